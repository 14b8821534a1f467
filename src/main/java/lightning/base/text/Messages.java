package lightning.base.text;

import java.util.Locale;
import java.util.Map;

/**
 * What the editor says, in the language that it speaks. A text is asked for by its English words, which are its key and what is shown in
 * English; a bundle has the words of another language. {@code {0}}, {@code {1}} … stand for values.
 *
 * <p>A process speaks English until it is told otherwise; only the editor tells.
 */
public final class Messages {
    private static volatile Bundle current = new Bundle(Language.ENGLISH, Map.of());

    private Messages() {
    }

    private record Bundle(Language language, Map<String, String> words) {
    }

    /** From now on texts are in this language. What was asked for before stays as it is. */
    public static void setLanguage(Language language) {
        if (language != current.language()) {
            current = new Bundle(language, MessageBundle.load(language));
        }
    }

    /** The language of the texts. */
    public static Language language() {
        return current.language();
    }

    /** How numbers on the screen are written. */
    public static Locale locale() {
        return language().locale();
    }

    /**
     * A text.
     *
     * @param english its English words; themselves where the bundle has none for them
     * @param values  what stands for {@code {0}}, {@code {1}} …, at most ten, each as it says itself
     */
    public static String tr(String english, Object... values) {
        return format(current.words().getOrDefault(english, english), values);
    }

    /**
     * A text about a number of things.
     *
     * @param singular    the words for one thing
     * @param plural   the words for none or several
     * @param values what stands for {@code {0}}, {@code {1}} …
     */
    public static String count(long count, String singular, String plural, Object... values) {
        return tr(count == 1 ? singular : plural, values);
    }

    /** English words that {@link #tr} is asked for later: marks them for who looks for all texts. */
    public static String key(String english) {
        return english;
    }

    private static String format(String pattern, Object... values) {
        if (values.length == 0) {
            return pattern;
        }
        var text = new StringBuilder();
        int position = 0;
        while (position < pattern.length()) {
            int index = position + 2 < pattern.length() && pattern.charAt(position) == '{' && pattern.charAt(position + 2) == '}'
                    ? pattern.charAt(position + 1) - '0'
                    : -1;
            if (index >= 0 && index < values.length) {
                text.append(values[index]);
                position += 3;
            } else {
                text.append(pattern.charAt(position++));
            }
        }
        return text.toString();
    }
}
