package lightning.text;

import java.util.OptionalDouble;

/**
 * Decimal numbers: a sign, digits 0 to 9 with a point before, among or after them, an exponent, as in {@code -1.5e-3}.
 * The one place that reads them, so that scene files, edits in words, motion paths, options and the editor's fields agree.
 * Java's own reading takes more: {@code 1d}, {@code 0x1p3}, {@code NaN}, digits of other scripts.
 */
public final class Decimal {
    private Decimal() {}

    /**
     * The nearest double to a number (IEEE 754, ties to even), infinite where it is beyond 1.8e308; empty if the whole text is not a number.
     */
    public static OptionalDouble read(String text) {
        return is(text, 0, text.length()) ? OptionalDouble.of(Double.parseDouble(text)) : OptionalDouble.empty();
    }

    /** Whether the characters from {@code from} to before {@code to} are a number. */
    public static boolean is(String text, int from, int to) {
        int i = from;
        if (isAny(text, i, to, "+-")) {
            i++;
        }
        int whole = digits(text, i, to);
        i += whole;
        int fraction = 0;
        if (isAny(text, i, to, ".")) {
            fraction = digits(text, i + 1, to);
            i += 1 + fraction;
        }
        if (whole + fraction == 0) {
            return false;
        }
        if (isAny(text, i, to, "eE")) {
            i++;
            if (isAny(text, i, to, "+-")) {
                i++;
            }
            int exponent = digits(text, i, to);
            return exponent > 0 && i + exponent == to;
        }
        return i == to;
    }

    /** The shortest number that reads back as {@code v}, the sign of zero included. */
    public static String text(double v) {
        if (v == 0) {
            return 1 / v < 0 ? "-0" : "0";
        }
        return v == Math.rint(v) && Math.abs(v) < 1e7 ? Long.toString((long) v)
                : Double.toString(v).replace(".0E", "E").replace('E', 'e');
    }

    private static boolean isAny(String text, int at, int to, String characters) {
        return at < to && characters.indexOf(text.charAt(at)) >= 0;
    }

    private static int digits(String text, int from, int to) {
        int i = from;
        while (i < to && text.charAt(i) >= '0' && text.charAt(i) <= '9') {
            i++;
        }
        return i - from;
    }
}
