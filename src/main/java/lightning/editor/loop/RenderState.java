package lightning.editor.loop;

import java.util.Optional;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.render.relight.plan.UpdatePlan;

/**
 * How far the picture is.
 *
 * @param plan         what is being done or was done last; null before the first
 * @param done         tiles finished; likewise {@code total}
 * @param checked      tiles of the verification finished; likewise {@code toCheck}, 0 where none runs
 * @param frame        the last picture; null before the first
 * @param measured     what an update saves, that of the last picture or an older one; null while nothing is known
 * @param verification the last one that ended since the picture came, or of the same; null where there is none
 * @param problem      why the last work failed; null if it did not
 * @param cancelled    whether the last work ended before its time
 */
public record RenderState(UpdatePlan plan, int done, int total, int checked, int toCheck, Frame frame, WarmSaving measured,
        Verification verification, Throwable problem, boolean cancelled) {
    public static final RenderState NONE = new RenderState(null, 0, 0, 0, 0, null, null, null, null, false);

    /** 0…1. */
    public double progress() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** What the update that made the picture saves; empty while that is not known. */
    public Optional<WarmSaving> saving() {
        return Optional.ofNullable(measured).filter(m -> frame != null && m.isOf(frame.update()));
    }

    public RenderState started(UpdatePlan next) {
        return new RenderState(next, 0, 0, checked, toCheck, frame, measured, verification, null, false);
    }

    public RenderState measured(WarmSaving saving) {
        return new RenderState(plan, done, total, checked, toCheck, frame, saving, verification, problem, cancelled);
    }

    public RenderState at(int tiles, int of) {
        return new RenderState(plan, tiles, of, checked, toCheck, frame, measured, verification, problem, cancelled);
    }

    public RenderState checking(int tiles, int of) {
        return new RenderState(plan, done, total, tiles, of, frame, measured, verification, null, false);
    }

    /** The last verdict goes where it is of another picture. */
    public RenderState rendered(Frame picture) {
        Verification still = verification != null && verification.speaksOf(picture.promise()) ? verification : null;
        return new RenderState(plan, done, total, checked, toCheck, picture, measured, still, problem, cancelled);
    }

    public RenderState verified(Verification result) {
        return new RenderState(plan, done, total, 0, 0, frame, measured, result, problem, cancelled);
    }

    public RenderState stopped(Throwable why) {
        return new RenderState(plan, done, total, 0, 0, frame, measured, verification, why, why == null);
    }
}
