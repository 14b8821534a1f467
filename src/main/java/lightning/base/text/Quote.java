package lightning.base.text;

import java.nio.file.Path;
import java.util.Collection;

/**
 * What a person or a file wrote, as messages quote it; the one place that does. Text that a line can show stays as it is, in
 * single quotes; any other is escaped as Git escapes the names of files, in double quotes: {@code "key\nlight"}.
 */
public final class Quote {
    /** Code points that are shown; every name that a scene may hold is shown whole. */
    private static final int LONGEST = 100;
    private static final String REST = "…";
    /** Characters of the names of files; more than any folder or file may have by itself. */
    private static final int LONGEST_PATH = 500;
    private static final int START_OF_PATH = 150;

    private Quote() {}

    /** What was found, in quotes, shortened where it has more than 100 characters. */
    public static String of(String found) {
        String shown = shortened(found);
        return Visible.is(shown) ? "'" + shown + "'" : escaped(shown);
    }

    /**
     * The name of a file: as it is where a line can show it, else escaped and in double quotes. Whole, but for the middle of one
     * that has more than 500 characters.
     */
    public static String path(String name) {
        String shown = name;
        if (name.length() > LONGEST_PATH) {
            int[] all = name.codePoints().toArray();
            int left = LONGEST_PATH - START_OF_PATH - REST.length();
            shown = all.length <= LONGEST_PATH ? name
                    : new String(all, 0, START_OF_PATH) + REST + new String(all, all.length - left, left);
        }
        return Visible.is(shown) && !shown.startsWith("\"") ? shown : escaped(shown);
    }

    /** A sentence in which each of some words is shortened where it has more than 100 characters. */
    public static String shortenedIn(String sentence, Collection<String> words) {
        String shown = sentence;
        for (String word : words) {
            shown = shown.replace(word, shortened(word));
        }
        return shown;
    }

    /** @see #path(String) */
    public static String path(Path path) {
        return path(path.toString());
    }

    /** The first 100 characters; a surrogate pair is never cut in two. */
    public static String shortened(String text) {
        // Most text is short, and only so much of the longest is looked at.
        if (text.length() <= LONGEST) {
            return text;
        }
        String start = text.substring(0, Math.min(text.length(), 2 * LONGEST + 2));
        return start.codePointCount(0, start.length()) <= LONGEST ? text
                : start.substring(0, start.offsetByCodePoints(0, LONGEST - REST.length())) + REST;
    }

    private static String escaped(String text) {
        return '"' + Visible.escaped(text.replace("\\", "\\\\").replace("\"", "\\\"")) + '"';
    }
}
