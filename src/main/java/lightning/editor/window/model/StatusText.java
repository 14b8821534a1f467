package lightning.editor.window.model;

import static java.util.Objects.requireNonNull;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.text.Messages;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderActivity;
import lightning.document.loop.RenderState;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import org.jspecify.annotations.Nullable;

/** Formats updates and verifications for the status line. */
public final class StatusText {
    /** Minimum rate that its text does not round to zero, million rays per second. */
    private static final double MIN_SHOWN_RATE = 0.05;

    private StatusText() {}

    /**
     * Formats an update: {@code key: full recompute · 5,021 shading points updated · 4,811 shadow rays · 8.3 ms · median 2.1 ms, full trace
     * 31 ms · 93.2 % saved · exact}.
     *
     * @param saving  saving of the frame's update; empty while it is not measured
     */
    public static String of(Frame frame, Optional<WarmSaving> saving) {
        return of(frame.update(), frame.isFinished(), frame.guarantee().text(frame.update()), saving);
    }

    /**
     * Formats an update whose picture may no longer exist.
     *
     * @param accuracyText  guarantee of the picture, for example {@code exact}
     */
    static String of(UpdateResult update, boolean isFinished, String accuracyText, Optional<WarmSaving> saving) {
        String text =
                Messages.tr("{0} · {1} shading points updated · {2} · {3}", update.plan().description(),
                        number(update.rowsTouched()), rays(update.rays()), milliseconds(update.milliseconds()));
        if (!isFinished) {
            return Messages.tr("{0} · not anti-aliased yet", text);
        }
        if (update.plan() instanceof UpdatePlan.Relight) {
            text += saving.map(StatusText::savingText).orElse(Messages.tr(" (measuring the saving…)"));
        }
        return text + " · " + accuracyText;
    }

    /**
     * Formats the rays of an update by purpose, with the light that has the most shadow rays: {@code 4,811 shadow rays, 2,000 of key · 310,000 rays of
     * indirect light · 40,000 rays of blurred reflections}.
     */
    private static String rays(RayCounts rays) {
        String text = rays.shadows().entrySet().stream().filter(light -> light.getValue() > 0 && light.getValue() < rays.shadow())
                .max(Map.Entry.comparingByValue())
                .map(most -> Messages.tr("{0} shadow rays, {1} of {2}", number(rays.shadow()), number(most.getValue()), most.getKey()))
                .orElseGet(() -> Messages.tr("{0} shadow rays", number(rays.shadow())));
        long reflected = rays.gathering().reflections();
        if (rays.gather() > reflected) {
            text += " · " + Messages.tr("{0} rays of indirect light", number(rays.gather() - reflected));
        }
        return reflected == 0 ? text : text + " · " + Messages.tr("{0} rays of blurred reflections", number(reflected));
    }

    /** Formats the update of an image briefly: {@code Updated in 0.8 ms, exact}. */
    public static String shortText(RenderState state) {
        Frame frame = requireNonNull(state.frame());
        UpdateResult update = frame.update();
        String time = time(update.milliseconds());
        String prefix = frame.step() == Frame.Step.INDIRECT_LIGHT ? Messages.tr("Indirect light in {0}", time)
                : update.plan() instanceof UpdatePlan.Relight ? Messages.tr("Updated in {0}", time) : Messages.tr("Traced in {0}", time);
        return prefix + ", " + (frame.isFinished() ? frame.guarantee().text(update) : Messages.tr("not anti-aliased yet"));
    }

    /** Formats a running render: {@code Refining… 42 % · 1.3 million rays/s}. Leaves out what is unknown. */
    public static String progress(RenderState state) {
        String stage = stage(state.activity().stage());
        String text = state.total() == 0 ? stage : stage + " " + percent(state.progress());
        double millions = state.activity().raysPerSecond() / 1e6;
        return millions < MIN_SHOWN_RATE ? text
                : text + " · " + String.format(Messages.locale(), Messages.tr("%.1f million rays/s"), millions);
    }

    /** Returns the name of a stage of an image that is being rendered: {@code Refining…}. */
    public static String stage(RenderActivity.Stage stage) {
        return switch (stage) {
            case CENTERS -> Messages.tr("Refining…");
            case INDIRECT -> Messages.tr("Indirect light…");
            case SAMPLES -> Messages.tr("Anti-aliasing…");
        };
    }

    private static String percent(double share) {
        return String.format(Messages.locale(), "%.0f %%", Math.floor(100 * share));
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
     * Formats a verification: {@code Verified: equal to a full trace in every bit (full trace 31 ms)}. Leaves out the time while the
     * process is not warm.
     *
     * @param frame  displayed picture; a result of another picture is marked as such
     */
    public static String of(Verification verification, @Nullable Frame frame) {
        String prefix = frame != null && verification.appliesTo(frame.guarantee()) ? "" : Messages.tr("Previous image: ");
        OptionalDouble full = verification.fullTraceMs();
        return prefix + verification.text() + (full.isPresent() ? Messages.tr(" (full trace {0})", milliseconds(full.getAsDouble())) : "");
    }

    public static String milliseconds(double v) {
        return String.format(Messages.locale(), v < 10 ? "%.1f ms" : "%.0f ms", v);
    }

    /** Formats a duration: {@code 0.8 ms}, {@code 1.3 s}. */
    public static String time(double milliseconds) {
        return milliseconds < 1000 ? milliseconds(milliseconds) : String.format(Messages.locale(), "%.1f s", milliseconds / 1000);
    }

    /** Formats an integer: {@code 5,021}. */
    public static String number(long v) {
        return String.format(Messages.locale(), "%,d", v);
    }
}
