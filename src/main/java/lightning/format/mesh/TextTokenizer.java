package lightning.format.mesh;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;

/**
 * Tokenizer for text files, line by line, without allocating an object per token. Lines end with {@code \n}, {@code \r\n} or
 * {@code \r}.
 */
public final class TextTokenizer {
    /** 10⁰ to 10²², which are exact doubles. */
    private static final double[] POWERS_OF_TEN = new double[23];
    /** Integers below this, multiplied by a power of ten of the table, are one rounding away from the nearest double. */
    private static final long MAX_EXACT_INTEGER = 1L << 53;
    private static final int MAX_DIGITS = 18;
    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    /** Words of C libraries for values that are no numbers, or infinite. */
    private static final Pattern NAN_PATTERN =
            Pattern.compile("[-+]?(nan(\\(\\w*\\))?|inf(inity)?|1\\.#(ind|inf|[qs]nan)\\d*)", Pattern.CASE_INSENSITIVE);

    static {
        double power = 1;
        for (int i = 0; i < POWERS_OF_TEN.length; i++, power *= 10) {
            POWERS_OF_TEN[i] = power;
        }
    }

    private final ByteSource bytes;
    private final byte[] token = new byte[MeshLimits.WORD_BYTES];
    private int length;
    private int line = 1;
    /** Set if the first line ends with a carriage return alone; a line feed after one is then not part of it. */
    private boolean endsLinesWithCr;

    public TextTokenizer(ByteSource bytes) {
        this.bytes = bytes;
    }

    /** Returns the line of the last token read, from 1. */
    public int line() {
        return line;
    }

    /** Creates a problem at this line. */
    public MeshException problem(String message) {
        return bytes.problem("line " + line, message);
    }

    /** Creates a problem of the content of this line alone. */
    public BadLineException badLine(String message) {
        return new BadLineException(bytes, line, message);
    }

    /** Skips a byte order mark of UTF-8, at the start of the file. */
    public void skipByteOrderMark() throws IOException {
        if (bytes.startsWith(BYTE_ORDER_MARK)) {
            for (int i = 0; i < BYTE_ORDER_MARK.length; i++) {
                bytes.next();
            }
        }
    }

    /**
     * Continues this line with the next one if the last token ends with a backslash at the end of the line, and removes the backslash.
     *
     * @return false if the last token does not end so
     */
    public boolean continueLine() throws IOException {
        if (length == 0 || token[length - 1] != '\\' || !isAtLineEnd()) {
            return false;
        }
        length--;
        nextLine();
        return true;
    }

    /**
     * Reads the next token of this line.
     *
     * @return false if there is none
     * @throws MeshException if it is longer than {@link MeshLimits#WORD_BYTES}
     */
    public boolean readToken() throws IOException, MeshException {
        int c = skipSpaces();
        length = 0;
        while (c >= 0 && c != ' ' && c != '\t' && c != '\n' && c != '\r') {
            if (length == token.length) {
                throw problem("a word must have at most " + token.length + " bytes, found more");
            }
            token[length++] = (byte) c;
            bytes.next();
            c = bytes.peek();
        }
        return length > 0;
    }

    /**
     * Skips the rest of this line.
     *
     * @return false if it was the last
     */
    public boolean nextLine() throws IOException {
        int c = bytes.next();
        while (c != '\n' && c != '\r' && c >= 0) {
            c = bytes.next();
        }
        if (c == '\r' && line == 1) {
            endsLinesWithCr = bytes.peek() != '\n';
        }
        if (c == '\r' && !endsLinesWithCr && bytes.peek() == '\n') {
            bytes.next();
        }
        line += c < 0 ? 0 : 1;
        return c >= 0 && bytes.peek() >= 0;
    }

    /** Skips the end of the line if only spaces precede it. */
    public void skipLineEnd() throws IOException {
        int c = skipSpaces();
        if (c == '\n' || c == '\r') {
            nextLine();
        }
    }

    /** Returns whether only spaces remain in this line. */
    public boolean isAtLineEnd() throws IOException {
        int c = skipSpaces();
        return c < 0 || c == '\n' || c == '\r';
    }

    /** Skips spaces and returns the next byte without consuming it; negative at the end of the file. */
    private int skipSpaces() throws IOException {
        int c = bytes.peek();
        while (c == ' ' || c == '\t') {
            bytes.next();
            c = bytes.peek();
        }
        return c;
    }

    /** Returns whether the last token equals the given one, which contains only ASCII letters. */
    public boolean isToken(String expected) {
        if (length != expected.length()) {
            return false;
        }
        for (int i = 0; i < length; i++) {
            if (token[i] != expected.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /** Decodes UTF-8; text that is not, as older programs write it, counts as Latin-1. */
    private static String decoded(byte[] text, int length) {
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(text, 0, length)).toString();
        } catch (CharacterCodingException e) {
            return new String(text, 0, length, StandardCharsets.ISO_8859_1);
        }
    }

    /** Returns the last token. */
    public String text() {
        return decoded(token, length);
    }

    /** Returns the rest of this line, trimmed. */
    public String restOfLine() throws IOException, MeshException {
        var rest = new ByteArrayOutputStream();
        for (int c = bytes.peek(); c >= 0 && c != '\n' && c != '\r'; c = bytes.peek()) {
            if (rest.size() == MeshLimits.WORD_BYTES) {
                throw problem("a name must have at most " + MeshLimits.WORD_BYTES + " bytes, found more");
            }
            rest.write(bytes.next());
        }
        return decoded(rest.toByteArray(), rest.size()).strip();
    }

    /** Returns the length of the last token in bytes. */
    public int length() {
        return length;
    }

    /** Returns a byte of the last token. */
    public byte byteAt(int index) {
        return token[index];
    }

    /**
     * Returns the nearest double to the last token.
     *
     * @param label expected content, for messages
     * @throws MeshException if it is not a decimal number in the range of doubles
     */
    public double number(String label) throws MeshException {
        double v = parseQuickly();
        if (!Double.isNaN(v)) {
            return v;
        }
        OptionalDouble parsed = DecimalNumber.parse(text());
        if (parsed.isEmpty() || !Double.isFinite(parsed.getAsDouble())) {
            throw badLine(label + " must be a decimal number, was " + Quote.of(text()));
        }
        return parsed.getAsDouble();
    }

    /** Returns the last token as a number, or NaN for C's spellings of it and of infinity: {@code nan}, {@code -NaN(ind)}, {@code 1.#INF}. */
    public double numberOrNaN(String label) throws MeshException {
        double v = parseQuickly();
        return !Double.isNaN(v) || NAN_PATTERN.matcher(text()).matches() ? v : number(label);
    }

    /**
     * Returns the last token as an integer.
     *
     * @throws MeshException if it is not an integer from {@code min} to {@code max}
     */
    public long integer(String label, long min, long max) throws MeshException {
        long v = 0;
        int i = length > 0 && (token[0] == '-' || token[0] == '+') ? 1 : 0;
        boolean valid = i < length && length - i <= MAX_DIGITS;
        for (; i < length && valid; i++) {
            valid = token[i] >= '0' && token[i] <= '9';
            v = 10 * v + token[i] - '0';
        }
        v = length > 0 && token[0] == '-' ? -v : v;
        if (!valid || v < min || v > max) {
            throw badLine(label + " must be a whole number from " + min + " to " + max + ", was " + Quote.of(text()));
        }
        return v;
    }

    /**
     * Parses a short number: an integer below 2⁵³ times or divided by a power of ten up to 10²², which needs only one
     * rounding (Clinger, How to read floating point numbers accurately, 1990). Returns NaN for anything else.
     */
    private double parseQuickly() {
        int i = 0;
        boolean negative = length > 0 && token[0] == '-';
        if (length > 0 && (negative || token[0] == '+')) {
            i++;
        }
        long digits = 0;
        int count = 0;
        int scale = 0;
        boolean hasPoint = false;
        for (; i < length; i++) {
            byte c = token[i];
            if (c >= '0' && c <= '9') {
                digits = 10 * digits + c - '0';
                count++;
                scale -= hasPoint ? 1 : 0;
            } else if (c == '.' && !hasPoint) {
                hasPoint = true;
            } else {
                break;
            }
            if (count > MAX_DIGITS) {
                return Double.NaN;
            }
        }
        if (count == 0 || digits >= MAX_EXACT_INTEGER) {
            return Double.NaN;
        }
        if (i < length) {
            int exponent = parseExponent(i);
            if (exponent == Integer.MIN_VALUE) {
                return Double.NaN;
            }
            scale += exponent;
        }
        if (Math.abs(scale) >= POWERS_OF_TEN.length) {
            return Double.NaN;
        }
        double v = scale < 0 ? digits / POWERS_OF_TEN[-scale] : digits * POWERS_OF_TEN[scale];
        return negative ? -v : v;
    }

    /**
     * Parses the exponent from the letter at {@code start} to the end, at most three digits; returns the smallest int if
     * invalid.
     */
    private int parseExponent(int start) {
        int i = start;
        if (token[i] != 'e' && token[i] != 'E' || ++i == length) {
            return Integer.MIN_VALUE;
        }
        boolean negative = token[i] == '-';
        if (negative || token[i] == '+') {
            i++;
        }
        if (i == length || length - i > 3) {
            return Integer.MIN_VALUE;
        }
        int exponent = 0;
        for (; i < length; i++) {
            if (token[i] < '0' || token[i] > '9') {
                return Integer.MIN_VALUE;
            }
            exponent = 10 * exponent + token[i] - '0';
        }
        return negative ? -exponent : exponent;
    }
}
