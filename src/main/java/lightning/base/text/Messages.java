package lightning.base.text;

import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * Translated texts of the editor. The English text is the key and the default; a bundle holds the texts of another language. {@code {0}},
 * {@code {1}} … are placeholders.
 *
 * <p>The language is English until it is set; only the editor sets it.
 */
public final class Messages {
    private static final Map<Language, Map<String, String>> BUNDLES = new ConcurrentHashMap<>();
    private static volatile Bundle current = new Bundle(Language.ENGLISH, Map.of());

    private Messages() {
    }

    private record Bundle(Language language, Map<String, String> words) {
    }

    /** Sets the language of all further texts. */
    public static void setLanguage(Language language) {
        if (language != current.language()) {
            current = new Bundle(language, BUNDLES.computeIfAbsent(language, MessageBundle::load));
        }
    }

    /** Returns the current language. */
    public static Language language() {
        return current.language();
    }

    /** Returns the locale of numbers on the screen. */
    public static Locale locale() {
        return language().locale();
    }

    /**
     * Translates a text.
     *
     * @param english the English text; used as is if the bundle has no translation
     * @param values  values of {@code {0}}, {@code {1}} …, at most ten, each formatted with {@code toString}
     */
    public static String tr(String english, @Nullable Object... values) {
        return format(current.words().getOrDefault(english, english), values);
    }

    /** Returns a text with its placeholders in a language, whatever the current one is. */
    public static String in(Language language, String english) {
        return BUNDLES.computeIfAbsent(language, MessageBundle::load).getOrDefault(english, english);
    }

    /**
     * Translates a text about a count.
     *
     * @param singular text for one
     * @param plural   text for zero or several
     * @param values   values of {@code {0}}, {@code {1}} …
     */
    public static String count(long count, String singular, String plural, Object... values) {
        return tr(count == 1 ? singular : plural, values);
    }

    /** Marks an English text that is passed to {@link #tr} later, so that a search finds all texts. */
    public static String key(String english) {
        return english;
    }

    private static String format(String pattern, @Nullable Object... values) {
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
