package lightning.editor.window.model;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.text.Messages;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.editor.loop.Frame;
import lightning.render.relight.UpdateResult;
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
        return of(frame.update(), frame.isFinished(), frame.guarantee().text(frame.update()), saving);
    }

    /**
     * The same of an update whose picture may be gone.
     *
     * @param accuracyText what the picture is: {@code exact}
     */
    static String of(UpdateResult update, boolean isFinished, String accuracyText, Optional<WarmSaving> saving) {
        String text =
                Messages.tr("{0} · {1} shading points updated · {2} shadow rays · {3}", update.plan().description(), number(update.rowsTouched()),
                        number(update.rays().shadow()), milliseconds(update.milliseconds()));
        if (!isFinished) {
            return Messages.tr("{0} · not anti-aliased yet", text);
        }
        if (update.plan() instanceof UpdatePlan.Relight) {
            text += saving.map(StatusText::savingText).orElse(Messages.tr(" (measuring the saving…)"));
        }
        return text + " · " + accuracyText;
    }

    /** In words of the work: {@code 0.8 ms, exact}. */
    public static String shortText(Frame frame) {
        UpdateResult update = frame.update();
        String time = time(update.milliseconds());
        String prefix = update.plan() instanceof UpdatePlan.Relight ? Messages.tr("Updated in {0}", time) : Messages.tr("Traced in {0}", time);
        return prefix + ", " + (frame.isFinished() ? frame.guarantee().text(update) : Messages.tr("not anti-aliased yet"));
    }

    private static String savingText(WarmSaving measured) {
        return Messages.tr(" · median {0}, full trace {1} · {2}", milliseconds(measured.update().median()),
                milliseconds(measured.full().median()), savingText(measured.percent() / 100));
    }

    public static String savingText(double share) {
        return share >= 0 ? String.format(Messages.locale(), Messages.tr("%.1f %% saved"), Math.floor(1000 * share) / 10)
                : String.format(Messages.locale(), Messages.tr("%.0f %% slower"), -100 * share);
    }

    /**
     * {@code Verified: equal to a full trace in every bit (full trace 31 ms)}; without a time where that would tell of a
     * process that is not warm yet.
     *
     * @param frame the picture shown; where the verdict is of another, it says so
     */
    public static String of(Verification verification, Frame frame) {
        String prefix = frame != null && verification.appliesTo(frame.guarantee()) ? "" : Messages.tr("Previous picture: ");
        OptionalDouble full = verification.fullTraceMs();
        return prefix + verification.text() + (full.isPresent() ? Messages.tr(" (full trace {0})", milliseconds(full.getAsDouble())) : "");
    }

    public static String milliseconds(double v) {
        return String.format(Messages.locale(), v < 10 ? "%.1f ms" : "%.0f ms", v);
    }

    /** {@code 0.8 ms}, {@code 1.3 s}. */
    public static String time(double milliseconds) {
        return milliseconds < 1000 ? milliseconds(milliseconds) : String.format(Messages.locale(), "%.1f s", milliseconds / 1000);
    }

    /** {@code 5,021}. */
    public static String number(long v) {
        return String.format(Messages.locale(), "%,d", v);
    }
}
