package lightning.base.text;

import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * Parser and formatter for decimal numbers: a sign, digits 0 to 9 with an optional point, and an exponent, as in {@code -1.5e-3}. Scene
 * files, command-line edits, motion paths, options and the editor's fields share it. Java's own parser accepts more: {@code 1d}, {@code
 * 0x1p3}, {@code NaN}, digits of other scripts.
 */
public final class DecimalNumber {
    /** The powers of ten that are exact doubles. */
    private static final double[] POWERS = IntStream.rangeClosed(0, 22).mapToDouble(k -> Double.parseDouble("1e" + k)).toArray();
    /** A prefix below this has room for one more digit: at most 18 digits, below 2⁶⁰. */
    private static final long MAX_PREFIX = 100_000_000_000_000_000L;

    private DecimalNumber() {}

    /** Returns the nearest double (IEEE 754, ties to even), infinite beyond 1.8e308; empty if the text is not a number. */
    public static OptionalDouble parse(String text) {
        return isNumber(text, 0, text.length()) ? OptionalDouble.of(parseRange(text, 0, text.length())) : OptionalDouble.empty();
    }

    /** Parses characters that {@link #isNumber} has accepted. */
    public static double parseRange(String text, int from, int to) {
        boolean negative = text.charAt(from) == '-';
        boolean point = false;
        long digits = 0;
        int decimals = 0;
        for (int i = isOneOf(text, from, to, "+-") ? from + 1 : from; i < to; i++) {
            int digit = text.charAt(i) - '0';
            if (digit >= 0 && digit <= 9 && digits < MAX_PREFIX) {
                digits = 10 * digits + digit;
                decimals += point ? 1 : 0;
            } else if (digit == '.' - '0') {
                point = true;
            } else {
                return Double.parseDouble(text.substring(from, to));
            }
        }
        double v = decimals < POWERS.length ? quotient(digits, POWERS[decimals]) : Double.NaN;
        return v >= 0 ? negative ? -v : v : Double.parseDouble(text.substring(from, to));
    }

    /**
     * Returns the double nearest to digits / power, or NaN if these steps cannot decide it.
     *
     * <p>Let digits = high + low, both doubles because digits are below 2⁶⁰, and let q be high / power rounded. Then high − q·power is a
     * double, as every remainder of a division is, so digits / power = q + D exactly, with D = (remainder + low) / power. The computed d
     * has two roundings and differs from D by at most 2⁻⁵¹·d. D therefore lies between d − g and d + g with g = 2⁻⁵⁰·d, including their own
     * rounding. Rounding is monotone, so the nearest double lies between q + (d − g) and q + (d + g), rounded; it is decided if both are
     * equal. Nothing underflows: q is 0 or at least 10⁻²².
     */
    private static double quotient(long digits, double power) {
        double high = digits;
        double low = digits - (long) high;
        double q = high / power;
        double d = (Math.fma(-q, power, high) + low) / power;
        double g = 0x1p-50 * Math.abs(d);
        double min = q + (d - g);
        return min == q + (d + g) ? min : Double.NaN;
    }

    /** Returns whether the characters from {@code from} to before {@code to} are a number. */
    public static boolean isNumber(String text, int from, int to) {
        int i = from;
        if (isOneOf(text, i, to, "+-")) {
            i++;
        }
        int integerDigits = countDigits(text, i, to);
        i += integerDigits;
        int fractionDigits = 0;
        if (isOneOf(text, i, to, ".")) {
            fractionDigits = countDigits(text, i + 1, to);
            i += 1 + fractionDigits;
        }
        if (integerDigits + fractionDigits == 0) {
            return false;
        }
        if (isOneOf(text, i, to, "eE")) {
            i++;
            if (isOneOf(text, i, to, "+-")) {
                i++;
            }
            int exponent = countDigits(text, i, to);
            return exponent > 0 && i + exponent == to;
        }
        return i == to;
    }

    /** Returns the shortest number that parses to {@code v}, including the sign of zero. */
    public static String format(double v) {
        if (v == 0) {
            return 1 / v < 0 ? "-0" : "0";
        }
        return v == Math.rint(v) && Math.abs(v) < 1e7 ? Long.toString((long) v)
                : Double.toString(v).replace(".0E", "E").replace('E', 'e');
    }

    private static boolean isOneOf(String text, int at, int to, String characters) {
        return at < to && characters.indexOf(text.charAt(at)) >= 0;
    }

    private static int countDigits(String text, int from, int to) {
        int i = from;
        while (i < to && text.charAt(i) >= '0' && text.charAt(i) <= '9') {
            i++;
        }
        return i - from;
    }
}
