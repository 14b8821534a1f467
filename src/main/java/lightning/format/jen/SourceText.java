package lightning.format.jen;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * Text of a scene file with line positions.
 *
 * @param name name of the file in problems
 * @param text lines end with {@code \n} or {@code \r\n}
 */
record SourceText(String name, String text) {
    private static final char REPLACEMENT = '\uFFFD';

    /** Decodes UTF-8. Reports each malformed sequence and replaces it by U+FFFD, so that the rest of the file can be checked. */
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

    /** Reports unpaired surrogates, which UTF-8 cannot encode. */
    void checkSurrogates(ProblemList problems) {
        for (int i = 0; i < text.length(); i++) {
            if (Character.isSurrogate(text.charAt(i))) {
                if (Character.isSupplementaryCodePoint(text.codePointAt(i))) {
                    i++;
                } else {
                    problems.add(i, String.format(Locale.ROOT, "found an unpaired surrogate, U+%04X", (int) text.charAt(i)));
                }
            }
        }
    }

    Problem toProblem(int offset, String message) {
        int end = Math.min(offset, text.length());
        int start = lineStart(end);
        return new Problem(name, line(end), text.codePointCount(start, end) + 1, message);
    }

    /** Returns the line of a character, from 1. */
    int line(int offset) {
        int line = 1;
        for (int i = text.indexOf('\n'); i >= 0 && i < offset; i = text.indexOf('\n', i + 1)) {
            line++;
        }
        return line;
    }

    /** Returns the offset of the first character in the line of {@code offset}. */
    int lineStart(int offset) {
        return text.lastIndexOf('\n', offset - 1) + 1;
    }

    /** Returns the offset of the line end ({@code \n} or {@code \r\n}) at or after {@code offset}, or of the end of the text. */
    int lineEnd(int offset) {
        int end = text.indexOf('\n', offset);
        if (end < 0) {
            return text.length();
        }
        return end > offset && text.charAt(end - 1) == '\r' ? end - 1 : end;
    }

    /** Returns the leading spaces and tabs of the line of {@code offset}. */
    String indent(int offset) {
        int start = lineStart(offset);
        int end = start;
        while (end < text.length() && isBlank(text.charAt(end))) {
            end++;
        }
        return text.substring(start, end);
    }

    /** Returns the line ending of the file. */
    String newline() {
        int first = text.indexOf('\n');
        return first > 0 && text.charAt(first - 1) == '\r' ? "\r\n" : "\n";
    }

    static boolean isBlank(char c) {
        return c == ' ' || c == '\t';
    }
}
