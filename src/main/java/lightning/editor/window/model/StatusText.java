package lightning.editor.window.model;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.text.Texts;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.editor.loop.Frame;
import lightning.render.relight.Update;
import lightning.render.relight.plan.UpdatePlan;

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
        String text = Texts.of("{0} · {1} rows touched · {2} shadow rays · {3}", update.plan().text(), number(update.rowsTouched()),
                number(update.rays().shadow()), milliseconds(update.milliseconds()));
        if (!finished) {
            return Texts.of("{0} · without finer samples yet", text);
        }
        if (update.plan() instanceof UpdatePlan.Relight) {
            text += saving.map(StatusText::saving).orElse(Texts.of(" (what it saves is being measured)"));
        }
        return text + " · " + promise;
    }

    /** In words of the work: {@code 0.8 ms, exact}. */
    public static String brief(Frame frame) {
        Update update = frame.update();
        String time = time(update.milliseconds());
        String what = update.plan() instanceof UpdatePlan.Relight ? time : Texts.of("Traced in {0}", time);
        return what + ", " + (frame.finished() ? frame.promise().text(update) : Texts.of("without finer samples yet"));
    }

    private static String saving(WarmSaving measured) {
        return Texts.of(" · made again {0} of {1} for a full trace · {2}", milliseconds(measured.update().median()),
                milliseconds(measured.full().median()), saving(measured.percent() / 100));
    }

    public static String saving(double share) {
        return share >= 0 ? String.format(Texts.locale(), Texts.of("%.1f %% saved"), Math.floor(1000 * share) / 10)
                : String.format(Texts.locale(), Texts.of("%.0f %% slower"), -100 * share);
    }

    /**
     * {@code Verified: equal to a full trace in every bit (full trace 31 ms)}; without a time where that would tell of a
     * process that is not warm yet.
     *
     * @param shown the picture shown; where the verdict is of another, it says so
     */
    public static String of(Verification verification, Frame shown) {
        String which = shown != null && verification.speaksOf(shown.promise()) ? "" : Texts.of("The picture before: ");
        OptionalDouble full = verification.fullTraceMs();
        return which + verification.text() + (full.isPresent() ? Texts.of(" (full trace {0})", milliseconds(full.getAsDouble())) : "");
    }

    public static String milliseconds(double v) {
        return String.format(Texts.locale(), v < 10 ? "%.1f ms" : "%.0f ms", v);
    }

    /** {@code 0.8 ms}, {@code 1.3 s}. */
    public static String time(double milliseconds) {
        return milliseconds < 1000 ? milliseconds(milliseconds) : String.format(Texts.locale(), "%.1f s", milliseconds / 1000);
    }

    /** {@code 5,021}. */
    public static String number(long v) {
        return String.format(Texts.locale(), "%,d", v);
    }
}
