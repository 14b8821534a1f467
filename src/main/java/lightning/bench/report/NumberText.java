package lightning.bench.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Number formatting for people. Missing numbers are dashes. */
final class NumberText {
    private static final String NONE = "–";
    private static final String SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private NumberText() {}

    /** Formats three digits: {@code 0.123}, {@code 12.3}, {@code 1 230}. */
    static String threeDigits(double value) {
        if (!Double.isFinite(value)) {
            return special(value);
        }
        double size = Math.abs(value);
        return size >= 1000 ? grouped(Math.round(value))
                : format(size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : size >= 1 ? "%.2f" : "%.3f", value);
    }

    /** Formats an axis tick: {@code 0.1}, {@code 5}, {@code 1 000}. */
    static String tick(double value) {
        return value >= 1000 ? grouped(Math.round(value)) : new BigDecimal(value).round(new MathContext(2))
                .stripTrailingZeros().toPlainString();
    }

    /** Formats a share, {@code 57.6 %}; never 0 if the part is positive. */
    static String share(long part, long whole) {
        double share = 100.0 * part / whole;
        return part == 0 ? "none" : share > 0 && share < 0.05 ? "< 0.1\u00a0%" : percent(share);
    }

    /** Formats a time: {@code 0.123 ms}. */
    static String ms(double value) {
        return Double.isFinite(value) ? threeDigits(value) + "\u00a0ms" : special(value);
    }

    /** Formats a percentage: {@code 97.1 %}. */
    static String percent(double value) {
        return Double.isFinite(value) ? format("%.1f\u00a0%%", value) : special(value);
    }

    /** Formats an error that may be tiny: {@code 0}, {@code 0.12}, {@code 3.1·10⁻⁸}. */
    static String error(double value) {
        if (!Double.isFinite(value) || value == 0) {
            return value == 0 ? "0" : special(value);
        }
        int exponent = (int) Math.floor(Math.log10(Math.abs(value)));
        return exponent >= -2 && exponent <= 3 ? format("%.3g", value)
                : format("%.1f", value / Math.pow(10, exponent)) + "·" + power(exponent);
    }

    /** Formats a power of ten: {@code 10⁻⁸}. */
    static String power(int exponent) {
        StringBuilder text = new StringBuilder("10").append(exponent < 0 ? "⁻" : "");
        Integer.toString(Math.abs(exponent)).chars().forEach(c -> text.append(SUPERSCRIPTS.charAt(c - '0')));
        return text.toString();
    }

    /** Formats grouped digits: {@code 1 234 567}. */
    static String grouped(long value) {
        return String.format(Locale.ROOT, "%,d", value).replace(',', '\u202f');
    }

    /** Formats a size: {@code 118 MB}. */
    static String bytes(double value) {
        return value >= 1e9 ? format("%.1f\u00a0GB", value / 1e9) : value >= 1e6 ? format("%.1f\u00a0MB", value / 1e6)
                : format("%.1f\u00a0kB", value / 1e3);
    }

    private static String special(double value) {
        return Double.isNaN(value) ? NONE : value > 0 ? "∞" : "−∞";
    }

    private static String format(String pattern, double value) {
        return String.format(Locale.ROOT, pattern, value).replace('-', '−');
    }
}
