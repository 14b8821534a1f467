package lightning.app.model;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import lightning.accuracy.Verification;
import lightning.accuracy.WarmSaving;
import lightning.edit.loop.Frame;
import lightning.relight.Update;
import lightning.relight.plan.UpdatePlan;

/** What the status line tells of an update and of a verification: what accuracy costs. */
public final class StatusText {
    private StatusText() {}

    /**
     * {@code key: full recompute · 5,021 rows touched · 4,811 shadow rays · 8.3 ms · made again 2.1 ms of 31 ms for a full trace ·
     * 93.2 % saved · exact}.
     *
     * @param saving of the frame's update; empty while that is not known
     */
    public static String of(Frame frame, Optional<WarmSaving> saving) {
        return of(frame.update(), frame.finished(), frame.promise().text(frame.update()), saving);
    }

    /**
     * The same of an update whose picture may be gone.
     *
     * @param promise what the picture is: {@code exact}
     */
    static String of(Update update, boolean finished, String promise, Optional<WarmSaving> saving) {
        String text = update.plan().text() + " · " + number(update.rowsTouched()) + " rows touched · "
                + number(update.rays().shadow()) + " shadow rays · " + milliseconds(update.milliseconds());
        if (!finished) {
            return text + " · without finer samples yet";
        }
        if (update.plan() instanceof UpdatePlan.Relight) {
            text += saving.map(StatusText::saving).orElse(" (what it saves is being measured)");
        }
        return text + " · " + promise;
    }

    /** In words of the work: {@code 0.8 ms, exact}. */
    public static String brief(Frame frame) {
        Update update = frame.update();
        String time = time(update.milliseconds());
        String what = update.plan() instanceof UpdatePlan.Relight ? time : "Traced in " + time;
        return what + ", " + (frame.finished() ? frame.promise().text(update) : "without finer samples yet");
    }

    private static String saving(WarmSaving measured) {
        return " · made again " + milliseconds(measured.update().median()) + " of " + milliseconds(measured.full().median())
                + " for a full trace · " + saving(measured.percent() / 100);
    }

    public static String saving(double share) {
        return share >= 0 ? String.format(Locale.ROOT, "%.1f %% saved", Math.floor(1000 * share) / 10)
                : String.format(Locale.ROOT, "%.0f %% slower", -100 * share);
    }

    /**
     * {@code Verified: equal to a full trace in every bit (full trace 31 ms)}; without a time where that would tell of a
     * process that is not warm yet.
     *
     * @param shown the picture shown; where the verdict is of another, it says so
     */
    public static String of(Verification verification, Frame shown) {
        String which = shown != null && verification.speaksOf(shown.promise()) ? "" : "The picture before: ";
        OptionalDouble full = verification.fullTraceMs();
        return which + verification.text() + (full.isPresent() ? " (full trace " + milliseconds(full.getAsDouble()) + ")" : "");
    }

    public static String milliseconds(double v) {
        return String.format(Locale.ROOT, v < 10 ? "%.1f ms" : "%.0f ms", v);
    }

    /** {@code 0.8 ms}, {@code 1.3 s}. */
    public static String time(double milliseconds) {
        return milliseconds < 1000 ? milliseconds(milliseconds) : String.format(Locale.ROOT, "%.1f s", milliseconds / 1000);
    }

    /** {@code 5,021}. */
    public static String number(long v) {
        return String.format(Locale.ROOT, "%,d", v);
    }
}
