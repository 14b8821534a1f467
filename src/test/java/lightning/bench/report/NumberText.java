package lightning.bench.report;

import java.util.Locale;

/** Number formatting of documents, as in the report. Missing numbers are dashes. */
final class NumberText {
    private static final String NONE = "–";

    private NumberText() {}

    /** Formats three digits: {@code 0.123}, {@code 12.3}, {@code 1 230}. */
    static String threeDigits(double value) {
        if (!Double.isFinite(value)) {
            return special(value);
        }
        double size = Math.abs(value);
        return size >= 1000 ? format("%,.0f", value).replace(',', '\u202f')
                : format(size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : size >= 1 ? "%.2f" : "%.3f", value);
    }

    /** Formats a percentage: {@code 97.1 %}. */
    static String percent(double value) {
        return Double.isFinite(value) ? format("%.1f\u00a0%%", value) : special(value);
    }

    private static String special(double value) {
        return Double.isNaN(value) ? NONE : value > 0 ? "∞" : "−∞";
    }

    private static String format(String pattern, double value) {
        return String.format(Locale.ROOT, pattern, value).replace('-', '−');
    }
}
