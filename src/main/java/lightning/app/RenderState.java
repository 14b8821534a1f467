package lightning.app;

import lightning.edit.Frame;
import lightning.edit.Verification;
import lightning.relight.UpdatePlan;

/**
 * How far the picture is.
 *
 * @param plan         what is being done or was done last; null before the first
 * @param done         tiles finished; likewise {@code total}
 * @param checked      tiles of the verification finished; likewise {@code toCheck}, 0 where none runs
 * @param frame        the last picture; null before the first
 * @param verification of a picture; null where none is finished
 * @param problem      why the last work failed; null if it did not
 * @param cancelled    whether the last work ended before its time
 */
public record RenderState(UpdatePlan plan, int done, int total, int checked, int toCheck, Frame frame,
        Verification verification, Throwable problem, boolean cancelled) {
    static final RenderState NONE = new RenderState(null, 0, 0, 0, 0, null, null, null, false);

    /** 0…1. */
    public double progress() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** Whether a verification runs. */
    public boolean isVerifying() {
        return toCheck > 0;
    }

    /** Whether a full trace of the picture in the frame was measured: of these shapes, this camera and this size. */
    public boolean isMeasured() {
        return verification != null && frame != null && verification.scene().picture().equals(frame.scene().picture())
                && verification.scene().camera().equals(frame.scene().camera())
                && verification.scene().nodes().equals(frame.scene().nodes());
    }

    RenderState started(UpdatePlan next) {
        return new RenderState(next, 0, 0, checked, toCheck, frame, verification, null, false);
    }

    RenderState at(int tiles, int of) {
        return new RenderState(plan, tiles, of, checked, toCheck, frame, verification, problem, cancelled);
    }

    RenderState checking(int tiles, int of) {
        return new RenderState(plan, done, total, tiles, of, frame, verification, null, false);
    }

    RenderState rendered(Frame picture) {
        return new RenderState(plan, done, total, checked, toCheck, picture, verification, problem, cancelled);
    }

    RenderState verified(Verification result) {
        return new RenderState(plan, done, total, 0, 0, frame, result, problem, cancelled);
    }

    RenderState stopped(Throwable why) {
        return new RenderState(plan, done, total, 0, 0, frame, verification, why, why == null);
    }
}
