package lightning.base.text;

import java.nio.file.Path;
import java.util.Collection;

/**
 * What a person or a file wrote, as messages quote it; the one place that does. Text that a line can show stays as it is, in
 * single quotes; any other is escaped as Git escapes the names of files, in double quotes: {@code "key\nlight"}.
 */
public final class Quote {
    /** Code points that are shown; every name that a scene may hold is shown whole. */
    private static final int MAX_LENGTH = 100;
    private static final String ELLIPSIS = "…";
    /** Characters of the names of files; more than any folder or file may have by itself. */
    private static final int MAX_PATH_LENGTH = 500;
    private static final int PATH_HEAD_LENGTH = 150;

    private Quote() {}

    /** What was found, in quotes, shortened where it has more than 100 characters. */
    public static String of(String text) {
        String shown = shorten(text);
        return PrintableText.isPrintable(shown) ? "'" + shown + "'" : escape(shown);
    }

    /**
     * The name of a file: as it is where a line can show it, else escaped and in double quotes. Whole, but for the middle of one
     * that has more than 500 characters.
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

    /** A sentence in which each of some words is shortened where it has more than 100 characters. */
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

    /** The first 100 characters; a surrogate pair is never cut in two. */
    public static String shorten(String text) {
        // Most text is short, and only so much of the longest is looked at.
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
