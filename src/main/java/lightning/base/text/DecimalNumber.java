package lightning.base.text;

import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * Decimal numbers: a sign, digits 0 to 9 with a point before, among or after them, an exponent, as in {@code -1.5e-3}.
 * The one place that reads them, so that scene files, edits in words, motion paths, options and the editor's fields agree.
 * Java's own reading takes more: {@code 1d}, {@code 0x1p3}, {@code NaN}, digits of other scripts.
 */
public final class DecimalNumber {
    /** The powers of ten that are doubles. */
    private static final double[] POWERS = IntStream.rangeClosed(0, 22).mapToDouble(k -> Double.parseDouble("1e" + k)).toArray();
    /** Digits below this have room for one more: no more than 18 are taken, a number below 2⁶⁰. */
    private static final long MAX_PREFIX = 100_000_000_000_000_000L;

    private DecimalNumber() {}

    /**
     * The nearest double to a number (IEEE 754, ties to even), infinite where it is beyond 1.8e308; empty if the whole text is not a number.
     */
    public static OptionalDouble parse(String text) {
        return isNumber(text, 0, text.length()) ? OptionalDouble.of(parseRange(text, 0, text.length())) : OptionalDouble.empty();
    }

    /** The same of characters of which {@link #isNumber} has told that they are a number. */
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
     * The double nearest to digits / power, or NaN where these steps cannot tell which it is.
     *
     * <p>With digits = high + low, both doubles as digits are below 2⁶⁰, and q = high / power rounded, high − q·power is a double
     * (a division's remainder always is), so that digits / power = q + D exactly with D = (remainder + low) / power. What is computed of D has two
     * roundings, and differs from it by at most 2⁻⁵¹ of what was computed. D therefore lies between d − g and d + g with g = 2⁻⁵⁰·d, their own
     * rounding included; and as rounding never turns an order around, the nearest double lies between q + (d − g) and q + (d + g), rounded: it is both
     * where they are the same. Nothing here is so small that it loses digits: q is 0 or at least 10⁻²².
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

    /** Whether the characters from {@code from} to before {@code to} are a number. */
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

    /** The shortest number that reads back as {@code v}, the sign of zero included. */
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
