package lightning.base.text;

/**
 * Which characters a line of text shows as they are. The others end a line, move what stands beside them, change colors of a
 * terminal, or cannot be seen at all; where a message must show one, it is escaped as Git escapes it.
 */
public final class PrintableText {
    private static final int ZERO_WIDTH_NON_JOINER = 0x200C;
    private static final int ZERO_WIDTH_JOINER = 0x200D;
    /** The letters of the escapes for U+0007 to U+000D, as in C. */
    private static final String ESCAPE_LETTERS = "abtnvfr";

    private PrintableText() {}

    /**
     * Whether a character is shown: a letter, mark, digit, sign or space. Controls, line and paragraph separators, marks of
     * direction, halves of surrogate pairs and code points that stand for nothing are not. The two joiners are, for words of
     * some scripts are spelled with them.
     */
    public static boolean isPrintable(int codePoint) {
        return switch (Character.getType(codePoint)) {
            case Character.CONTROL, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
                    Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> false;
            case Character.FORMAT -> codePoint == ZERO_WIDTH_NON_JOINER || codePoint == ZERO_WIDTH_JOINER;
            default -> true;
        };
    }

    /** Whether a line shows the whole text as it is. */
    public static boolean isPrintable(String text) {
        for (int i = 0, c; i < text.length(); i += Character.charCount(c)) {
            c = text.codePointAt(i);
            if (!isPrintable(c)) {
                return false;
            }
        }
        return true;
    }

    /**
     * The text with each character that is not shown escaped: {@code \n} and its kind for those that have a letter in C, else
     * three octal digits for each byte of its UTF-8 form.
     */
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
            // By hand, since Java's encoder has no bytes for half of a surrogate pair.
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
