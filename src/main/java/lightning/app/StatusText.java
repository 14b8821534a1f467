package lightning.app;

import java.util.Locale;
import lightning.accuracy.Verification;
import lightning.edit.Frame;
import lightning.relight.Update;
import lightning.relight.UpdatePlan;

/** What the status line tells of an update and of a verification: what accuracy costs. */
final class StatusText {
    private StatusText() {}

    /**
     * {@code key: full recompute · 5,021 rows touched · 4,811 shadow rays · 2.1 ms of 31 ms for a full trace · 93.2 % saved ·
     * exact}. The first trace of a picture runs before Java is warm and is no yardstick.
     *
     * @param fullTraceMs how long a warm full trace takes, milliseconds; NaN while that is not known
     */
    static String of(Frame frame, double fullTraceMs) {
        Update update = frame.update();
        String text = update.plan().text() + " · " + number(update.rowsTouched()) + " rows touched · "
                + number(update.rays().shadow()) + " shadow rays · " + milliseconds(update.milliseconds());
        if (!(update.plan() instanceof UpdatePlan.FirstPass)) {
            text += Double.isNaN(fullTraceMs) ? " (a full trace is still being measured)"
                    : " of " + milliseconds(fullTraceMs) + " for a full trace · " + saving(1 - update.milliseconds() / fullTraceMs);
        }
        return text + " · " + frame.promise().text(frame.update());
    }

    static String saving(double share) {
        return share >= 0 ? String.format(Locale.ROOT, "%.1f %% saved", Math.floor(1000 * share) / 10)
                : String.format(Locale.ROOT, "%.0f %% slower", -100 * share);
    }

    /**
     * {@code Verified: equal to a full trace in every bit (full trace 31 ms)}.
     *
     * @param shown the picture shown; where the verdict is of another, it says so
     */
    static String of(Verification verification, Frame shown) {
        String which = shown != null && verification.speaksOf(shown.promise()) ? "" : "The picture before: ";
        return which + verification.text() + " (full trace " + milliseconds(verification.fullTraceMs()) + ")";
    }

    static String milliseconds(double v) {
        return String.format(Locale.ROOT, v < 10 ? "%.1f ms" : "%.0f ms", v);
    }

    private static String number(long v) {
        return String.format(Locale.ROOT, "%,d", v);
    }
}
