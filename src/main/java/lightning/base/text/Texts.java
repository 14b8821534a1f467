package lightning.base.text;

import java.util.Locale;
import java.util.Map;

/**
 * What the editor says, in the language that it speaks. A text is asked for by its English words, which are its key and what is shown in
 * English; a bundle has the words of another language. {@code {0}}, {@code {1}} … stand for values.
 *
 * <p>A process speaks English until it is told otherwise; only the editor tells.
 */
public final class Texts {
    private static volatile Bundle spoken = new Bundle(Language.ENGLISH, Map.of());

    private Texts() {
    }

    private record Bundle(Language language, Map<String, String> words) {
    }

    /** From now on texts are in this language. What was asked for before stays as it is. */
    public static void speak(Language language) {
        if (language != spoken.language()) {
            spoken = new Bundle(language, TextBundle.of(language));
        }
    }

    /** The language of the texts. */
    public static Language language() {
        return spoken.language();
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
    public static String of(String english, Object... values) {
        return filled(spoken.words().getOrDefault(english, english), values);
    }

    /**
     * A text about a number of things.
     *
     * @param one    the words for one thing
     * @param many   the words for none or several
     * @param values what stands for {@code {0}}, {@code {1}} …
     */
    public static String count(long number, String one, String many, Object... values) {
        return of(number == 1 ? one : many, values);
    }

    /** English words that {@link #of} is asked for later: marks them for who looks for all texts. */
    public static String key(String english) {
        return english;
    }

    private static String filled(String pattern, Object... values) {
        if (values.length == 0) {
            return pattern;
        }
        var text = new StringBuilder();
        int at = 0;
        while (at < pattern.length()) {
            int value = at + 2 < pattern.length() && pattern.charAt(at) == '{' && pattern.charAt(at + 2) == '}'
                    ? pattern.charAt(at + 1) - '0'
                    : -1;
            if (value >= 0 && value < values.length) {
                text.append(values[value]);
                at += 3;
            } else {
                text.append(pattern.charAt(at++));
            }
        }
        return text.toString();
    }
}
