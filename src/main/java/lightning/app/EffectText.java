package lightning.app;

import java.util.Locale;
import lightning.accuracy.EffectCost;

/** What an effect takes, in words. */
final class EffectText {
    private static final double KILO = 1e3;
    private static final double MEGA = 1e6;

    private EffectText() {}

    /** {@code 3.2 ms of the first pass, 0.4 ms of the update, 1.2 MB}. */
    static String of(EffectCost cost) {
        String first = Math.abs(cost.firstMs()) <= cost.firstNoise() ? "no time to tell" : milliseconds(cost.firstMs());
        return first + " of the first pass, " + milliseconds(cost.updateMs()) + " of the update, " + bytes(cost.bytes());
    }

    private static String milliseconds(double v) {
        return String.format(Locale.ROOT, "%.1f ms", v).replace("-0.0", "0.0");
    }

    private static String bytes(long v) {
        return Math.abs(v) < MEGA ? String.format(Locale.ROOT, "%.0f kB", v / KILO) : String.format(Locale.ROOT, "%.1f MB", v / MEGA);
    }
}
