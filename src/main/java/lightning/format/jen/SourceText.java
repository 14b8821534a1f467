package lightning.format.jen;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The characters of a scene file and their places.
 *
 * @param name how problems call the file
 * @param text lines end with {@code \n} or {@code \r\n}
 */
record SourceText(String name, String text) {
    private static final char REPLACEMENT = '\uFFFD';

    /**
     * Decodes UTF-8. Each malformed sequence is a problem and becomes U+FFFD, so that the rest of
     * the file can still be checked.
     */
    static SourceText decode(String name, byte[] bytes, ProblemList problems) {
        String decoded = new String(bytes, StandardCharsets.UTF_8);
        if (decoded.indexOf(REPLACEMENT) < 0) {
            return new SourceText(name, decoded);
        }
        var in = ByteBuffer.wrap(bytes);
        var out = CharBuffer.allocate(bytes.length + 1);
        var decoder = StandardCharsets.UTF_8.newDecoder();
        while (true) {
            CoderResult result = decoder.decode(in, out, true);
            if (result.isUnderflow()) {
                return new SourceText(name, out.flip().toString());
            }
            problems.add(out.position(), String.format(Locale.ROOT,
                    "the file must be UTF-8 text, found the malformed byte 0x%02X", in.get(in.position())));
            in.position(in.position() + result.length());
            out.put(REPLACEMENT);
        }
    }

    /** Reports halves of surrogate pairs, which no file can hold. */
    void checkSurrogates(ProblemList problems) {
        for (int i = 0; i < text.length(); i++) {
            if (Character.isSurrogate(text.charAt(i))) {
                if (Character.isSupplementaryCodePoint(text.codePointAt(i))) {
                    i++;
                } else {
                    problems.add(i, String.format(Locale.ROOT, "found half of a character, U+%04X", (int) text.charAt(i)));
                }
            }
        }
    }

    Problem toProblem(int offset, String message) {
        int end = Math.min(offset, text.length());
        int start = lineStart(end);
        return new Problem(name, line(end), text.codePointCount(start, end) + 1, message);
    }

    /** The line of a character, from 1. */
    int line(int offset) {
        int line = 1;
        for (int i = text.indexOf('\n'); i >= 0 && i < offset; i = text.indexOf('\n', i + 1)) {
            line++;
        }
        return line;
    }

    /** The offset of the first character of the line that holds the character {@code offset}. */
    int lineStart(int offset) {
        return text.lastIndexOf('\n', offset - 1) + 1;
    }

    /** The offset of the line end ({@code \n} or {@code \r\n}) at or after {@code offset}, or of the end of the text. */
    int lineEnd(int offset) {
        int end = text.indexOf('\n', offset);
        if (end < 0) {
            return text.length();
        }
        return end > offset && text.charAt(end - 1) == '\r' ? end - 1 : end;
    }

    /** The spaces and tabs that begin the line of the character {@code offset}. */
    String indent(int offset) {
        int start = lineStart(offset);
        int end = start;
        while (end < text.length() && isBlank(text.charAt(end))) {
            end++;
        }
        return text.substring(start, end);
    }

    /** The line end that the file uses. */
    String newline() {
        int first = text.indexOf('\n');
        return first > 0 && text.charAt(first - 1) == '\r' ? "\r\n" : "\n";
    }

    static boolean isBlank(char c) {
        return c == ' ' || c == '\t';
    }
}
