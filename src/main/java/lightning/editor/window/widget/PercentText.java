package lightning.editor.window.widget;

import lightning.base.text.Messages;

/** Formats fractions as short percentages. */
public final class PercentText {
    private static final double HUNDRED = 100;

    private PercentText() {}

    /** Formats a fraction: {@code 12 %}, {@code 4.1 %}, {@code < 0.1 %}. Only 0 is formatted as zero. */
    public static String format(double fraction) {
        double percent = fraction * HUNDRED;
        return percent == 0 ? "0 %" : percent < 0.1 ? "< 0.1 %"
                : String.format(Messages.locale(), percent < 10 ? "%.1f %%" : "%.0f %%", percent);
    }
}
