package lightning.editor.window.widget;

import lightning.base.text.Texts;

/** Parts in per cent, short enough to be compared at a glance. */
public final class Percent {
    private static final double HUNDRED = 100;

    private Percent() {}

    /** A part that is there is never told as none: {@code 12 %}, {@code 4.1 %}, {@code < 0.1 %}. */
    public static String text(double part) {
        double percent = part * HUNDRED;
        return percent == 0 ? "0 %" : percent < 0.1 ? "< 0.1 %"
                : String.format(Texts.locale(), percent < 10 ? "%.1f %%" : "%.0f %%", percent);
    }
}
