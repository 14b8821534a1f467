package lightning.base.text;

/**
 * Printable characters of a line of text. Other characters break the line, move text next to them, change a terminal's colors, or are
 * invisible; messages escape them as Git does.
 */
public final class PrintableText {
    private static final int ZERO_WIDTH_NON_JOINER = 0x200C;
    private static final int ZERO_WIDTH_JOINER = 0x200D;
    /** The letters of the escapes for U+0007 to U+000D, as in C. */
    private static final String ESCAPE_LETTERS = "abtnvfr";

    private PrintableText() {}

    /**
     * Returns whether a character is printable: a letter, mark, digit, symbol or space. Control characters, line and paragraph separators,
     * direction marks, unpaired surrogates and unassigned code points are not. The two joiners are, because some scripts need them.
     */
    public static boolean isPrintable(int codePoint) {
        return switch (Character.getType(codePoint)) {
            case Character.CONTROL, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
                    Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> false;
            case Character.FORMAT -> codePoint == ZERO_WIDTH_NON_JOINER || codePoint == ZERO_WIDTH_JOINER;
            default -> true;
        };
    }

    /** Returns whether all characters of a text are printable. */
    public static boolean isPrintable(String text) {
        for (int i = 0, c; i < text.length(); i += Character.charCount(c)) {
            c = text.codePointAt(i);
            if (!isPrintable(c)) {
                return false;
            }
        }
        return true;
    }

    /** Escapes the characters that are not printable: {@code \n} and other C escapes, else three octal digits for each UTF-8 byte. */
    public static String escape(String text) {
        if (isPrintable(text)) {
            return text;
        }
        var out = new StringBuilder();
        text.codePoints().forEach(c -> {
            if (isPrintable(c)) {
                out.appendCodePoint(c);
            } else {
                escape(c, out);
            }
        });
        return out.toString();
    }

    private static void escape(int c, StringBuilder out) {
        if (c >= 7 && c < 7 + ESCAPE_LETTERS.length()) {
            out.append('\\').append(ESCAPE_LETTERS.charAt(c - 7));
        } else if (c < 0x80) {
            octal(c, out);
        } else {
            // Encodes by hand, because Java's encoder has no bytes for an unpaired surrogate.
            int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
            octal(0xF0 << 3 - more & 0xFF | c >> 6 * more, out);
            for (int i = more - 1; i >= 0; i--) {
                octal(0x80 | c >> 6 * i & 0x3F, out);
            }
        }
    }

    private static void octal(int b, StringBuilder out) {
        out.append('\\').append((char) ('0' + (b >> 6))).append((char) ('0' + (b >> 3 & 7))).append((char) ('0' + (b & 7)));
    }
}
