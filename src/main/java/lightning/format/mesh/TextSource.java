package lightning.format.mesh;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;

/** The words of a file of text, line by line, without an object for each. Lines end with {@code \n}, {@code \r\n} or {@code \r}. */
public final class TextSource {
    /** 10⁰ to 10²², which doubles hold exactly. */
    private static final double[] POWERS = new double[23];
    /** Whole numbers below it, and times a power of ten of the table, are one rounding away from the nearest double. */
    private static final long EXACT = 1L << 53;
    private static final int MOST_DIGITS = 18;
    private static final Pattern NOT_A_NUMBER = Pattern.compile("[-+]?nan(\\(\\w*\\))?", Pattern.CASE_INSENSITIVE);

    static {
        double power = 1;
        for (int i = 0; i < POWERS.length; i++, power *= 10) {
            POWERS[i] = power;
        }
    }

    private final ByteSource bytes;
    private final byte[] word = new byte[MeshLimits.WORD_BYTES];
    private int length;
    private int line = 1;
    /** Whether the first line ends with a return alone, so that a new line behind one is no part of it. */
    private boolean returnsAlone;

    public TextSource(ByteSource bytes) {
        this.bytes = bytes;
    }

    /** The line of the word that was read last, from 1. */
    public int line() {
        return line;
    }

    /** A problem with this line. */
    public MeshException problem(String message) {
        return bytes.problem("line " + line, message);
    }

    /**
     * Reads the next word of this line.
     *
     * @return false if there is none
     * @throws MeshException if it is longer than {@link MeshLimits#WORD_BYTES}
     */
    public boolean word() throws IOException, MeshException {
        int c = passSpaces();
        length = 0;
        while (c >= 0 && c != ' ' && c != '\t' && c != '\n' && c != '\r') {
            if (length == word.length) {
                throw problem("a word must have at most " + word.length + " bytes, found more");
            }
            word[length++] = (byte) c;
            bytes.next();
            c = bytes.peek();
        }
        return length > 0;
    }

    /**
     * Leaves the rest of this line out.
     *
     * @return false if it was the last
     */
    public boolean nextLine() throws IOException {
        int c = bytes.next();
        while (c != '\n' && c != '\r' && c >= 0) {
            c = bytes.next();
        }
        if (c == '\r' && line == 1) {
            returnsAlone = bytes.peek() != '\n';
        }
        if (c == '\r' && !returnsAlone && bytes.peek() == '\n') {
            bytes.next();
        }
        line += c < 0 ? 0 : 1;
        return c >= 0 && bytes.peek() >= 0;
    }

    /** Passes the end of a line where there is nothing else between here and there. */
    public void passLineEnd() throws IOException {
        int c = passSpaces();
        if (c == '\n' || c == '\r') {
            nextLine();
        }
    }

    /** Whether nothing but spaces is left of this line. */
    public boolean isAtLineEnd() throws IOException {
        int c = passSpaces();
        return c < 0 || c == '\n' || c == '\r';
    }

    /** The first byte behind spaces, which stays to be read; negative at the end of the file. */
    private int passSpaces() throws IOException {
        int c = bytes.peek();
        while (c == ' ' || c == '\t') {
            bytes.next();
            c = bytes.peek();
        }
        return c;
    }

    /** Whether the last word is this one, which has ASCII letters only. */
    public boolean is(String expected) {
        if (length != expected.length()) {
            return false;
        }
        for (int i = 0; i < length; i++) {
            if (word[i] != expected.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /** The last word. */
    public String text() {
        return new String(word, 0, length, StandardCharsets.UTF_8);
    }

    /** What is left of this line, without spaces at its ends. */
    public String rest() throws IOException, MeshException {
        var rest = new ByteArrayOutputStream();
        for (int c = bytes.peek(); c >= 0 && c != '\n' && c != '\r'; c = bytes.peek()) {
            if (rest.size() == MeshLimits.WORD_BYTES) {
                throw problem("a name must have at most " + MeshLimits.WORD_BYTES + " bytes, found more");
            }
            rest.write(bytes.next());
        }
        return rest.toString(StandardCharsets.UTF_8).strip();
    }

    /** How many bytes the last word has. */
    public int length() {
        return length;
    }

    /** A byte of the last word. */
    public byte at(int index) {
        return word[index];
    }

    /**
     * The last word as a number: the nearest double.
     *
     * @param what what is expected, in messages
     * @throws MeshException if it is no decimal number, or none that a double can hold
     */
    public double number(String what) throws MeshException {
        double v = quickNumber();
        if (!Double.isNaN(v)) {
            return v;
        }
        OptionalDouble read = Decimal.read(text());
        if (read.isEmpty() || !Double.isFinite(read.getAsDouble())) {
            throw problem(what + " must be a decimal number, was " + Quote.of(text()));
        }
        return read.getAsDouble();
    }

    /** The same, NaN where the word is C's way of writing that there is no number: {@code nan}, {@code -NaN(ind)}. */
    public double numberOrNaN(String what) throws MeshException {
        double v = quickNumber();
        return !Double.isNaN(v) || NOT_A_NUMBER.matcher(text()).matches() ? v : number(what);
    }

    /**
     * The last word as a whole number.
     *
     * @throws MeshException if it is none from {@code min} to {@code max}
     */
    public long whole(String what, long min, long max) throws MeshException {
        long v = 0;
        int i = length > 0 && (word[0] == '-' || word[0] == '+') ? 1 : 0;
        boolean digits = i < length && length - i <= MOST_DIGITS;
        for (; i < length && digits; i++) {
            digits = word[i] >= '0' && word[i] <= '9';
            v = 10 * v + word[i] - '0';
        }
        v = length > 0 && word[0] == '-' ? -v : v;
        if (!digits || v < min || v > max) {
            throw problem(what + " must be a whole number from " + min + " to " + max + ", was " + Quote.of(text()));
        }
        return v;
    }

    /**
     * The last word where it has few digits: a whole number below 2⁵³ times or over a power of ten up to 10²² is rounded once
     * (Clinger, How to read floating point numbers accurately, 1990). NaN where it is anything else.
     */
    private double quickNumber() {
        int i = 0;
        boolean negative = length > 0 && word[0] == '-';
        if (length > 0 && (negative || word[0] == '+')) {
            i++;
        }
        long digits = 0;
        int count = 0;
        int scale = 0;
        boolean point = false;
        for (; i < length; i++) {
            byte c = word[i];
            if (c >= '0' && c <= '9') {
                digits = 10 * digits + c - '0';
                count++;
                scale -= point ? 1 : 0;
            } else if (c == '.' && !point) {
                point = true;
            } else {
                break;
            }
            if (count > MOST_DIGITS) {
                return Double.NaN;
            }
        }
        if (count == 0 || digits >= EXACT) {
            return Double.NaN;
        }
        if (i < length) {
            int exponent = exponent(i);
            if (exponent == Integer.MIN_VALUE) {
                return Double.NaN;
            }
            scale += exponent;
        }
        if (Math.abs(scale) >= POWERS.length) {
            return Double.NaN;
        }
        double v = scale < 0 ? digits / POWERS[-scale] : digits * POWERS[scale];
        return negative ? -v : v;
    }

    /** The exponent from the letter at {@code from} to the end, of at most three digits; the least integer where there is none. */
    private int exponent(int from) {
        int i = from;
        if (word[i] != 'e' && word[i] != 'E' || ++i == length) {
            return Integer.MIN_VALUE;
        }
        boolean negative = word[i] == '-';
        if (negative || word[i] == '+') {
            i++;
        }
        if (i == length || length - i > 3) {
            return Integer.MIN_VALUE;
        }
        int exponent = 0;
        for (; i < length; i++) {
            if (word[i] < '0' || word[i] > '9') {
                return Integer.MIN_VALUE;
            }
            exponent = 10 * exponent + word[i] - '0';
        }
        return negative ? -exponent : exponent;
    }
}
