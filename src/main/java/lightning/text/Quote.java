package lightning.text;

import java.nio.file.Path;

/**
 * What a person or a file wrote, as messages quote it; the one place that does. Text that a line can show stays as it is, in
 * single quotes; any other is escaped as Git escapes the names of files, in double quotes: {@code "key\nlight"}.
 */
public final class Quote {
    /** Code points that are shown; every name that a scene may hold is shown whole. */
    private static final int LONGEST = 100;
    private static final String REST = "…";

    private Quote() {}

    /** What was found, in quotes, shortened where it has more than 100 characters. */
    public static String of(String found) {
        String shown = shortened(found);
        return Visible.is(shown) ? "'" + shown + "'" : escaped(shown);
    }

    /** The name of a file, whole: as it is where a line can show it, else escaped and in double quotes. */
    public static String path(String name) {
        return Visible.is(name) && !name.startsWith("\"") ? name : escaped(name);
    }

    /** @see #path(String) */
    public static String path(Path path) {
        return path(path.toString());
    }

    /** The first characters; a surrogate pair is never cut in two. */
    private static String shortened(String text) {
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
