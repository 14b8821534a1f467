package lightning.base.text;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Quoting of user and file input in messages. Printable text stays as it is, in single quotes; other text is escaped as Git escapes file
 * names, in double quotes: {@code "key\nlight"}.
 */
public final class Quote {
    /** Maximum code points shown; every valid scene name is shown in full. */
    private static final int MAX_LENGTH = 100;
    private static final String ELLIPSIS = "…";
    /** Maximum texts of a list that are shown. */
    private static final int MAX_LISTED = 20;
    /** Maximum characters of a file name; longer than any single folder or file name. */
    private static final int MAX_PATH_LENGTH = 500;
    private static final int PATH_HEAD_LENGTH = 150;

    private Quote() {}

    /** Returns a text in quotes, shortened to 100 characters. */
    public static String of(String text) {
        String shown = shorten(text);
        return PrintableText.isPrintable(shown) ? "'" + shown + "'" : escape(shown);
    }

    /** Returns texts in quotes, separated by commas; of more than 20 the first. */
    public static String list(List<String> texts) {
        return texts.stream().limit(MAX_LISTED).map(Quote::of).collect(Collectors.joining(", ")) + (texts.size() > MAX_LISTED ? " …" : "");
    }

    /**
     * Returns a file name: as it is if printable, else escaped and in double quotes. Removes the middle of names longer than 500
     * characters.
     */
    public static String path(String name) {
        String shown = name;
        if (name.length() > MAX_PATH_LENGTH) {
            int[] codePoints = name.codePoints().toArray();
            int tailLength = MAX_PATH_LENGTH - PATH_HEAD_LENGTH - ELLIPSIS.length();
            shown = codePoints.length <= MAX_PATH_LENGTH ? name
                    : new String(codePoints, 0, PATH_HEAD_LENGTH) + ELLIPSIS
                            + new String(codePoints, codePoints.length - tailLength, tailLength);
        }
        return PrintableText.isPrintable(shown) && !shown.startsWith("\"") ? shown : escape(shown);
    }

    /** Returns a sentence with the given words shortened to 100 characters each. */
    public static String shortenWords(String sentence, Collection<String> words) {
        String shown = sentence;
        for (String word : words) {
            shown = shown.replace(word, shorten(word));
        }
        return shown;
    }

    /** @see #path(String) */
    public static String path(Path path) {
        return path(path.toString());
    }

    /** Returns the first 100 characters; never splits a surrogate pair. */
    public static String shorten(String text) {
        // Most texts are short; a long one is examined only up to the limit.
        if (text.length() <= MAX_LENGTH) {
            return text;
        }
        String start = text.substring(0, Math.min(text.length(), 2 * MAX_LENGTH + 2));
        return start.codePointCount(0, start.length()) <= MAX_LENGTH ? text
                : start.substring(0, start.offsetByCodePoints(0, MAX_LENGTH - ELLIPSIS.length())) + ELLIPSIS;
    }

    private static String escape(String text) {
        return '"' + PrintableText.escape(text.replace("\\", "\\\\").replace("\"", "\\\"")) + '"';
    }
}
