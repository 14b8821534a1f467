package lightning.app;

import lightning.accuracy.Verification;
import lightning.edit.Frame;
import lightning.relight.UpdatePlan;

/**
 * How far the picture is.
 *
 * @param plan         what is being done or was done last; null before the first
 * @param done         tiles finished; likewise {@code total}
 * @param checked      tiles of the verification finished; likewise {@code toCheck}, 0 where none runs
 * @param frame        the last picture; null before the first
 * @param fullTraceMs  how long a warm full trace of it takes, milliseconds; NaN while that is not known
 * @param verification the last one that ended since the picture came, or of the same; null where there is none
 * @param problem      why the last work failed; null if it did not
 * @param cancelled    whether the last work ended before its time
 */
public record RenderState(UpdatePlan plan, int done, int total, int checked, int toCheck, Frame frame, double fullTraceMs,
        Verification verification, Throwable problem, boolean cancelled) {
    static final RenderState NONE = new RenderState(null, 0, 0, 0, 0, null, Double.NaN, null, null, false);

    /** 0…1. */
    public double progress() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** Whether a verification runs. */
    public boolean isVerifying() {
        return toCheck > 0;
    }

    RenderState started(UpdatePlan next) {
        // A full trace of other samples takes another time.
        double ms = switch (next) {
            case UpdatePlan.FirstPass _ -> Double.NaN;
            case UpdatePlan.Relight relight -> relight.resampled() ? Double.NaN : fullTraceMs;
            case UpdatePlan.Nothing _ -> fullTraceMs;
        };
        return new RenderState(next, 0, 0, checked, toCheck, frame, ms, verification, null, false);
    }

    RenderState measured(double milliseconds) {
        return new RenderState(plan, done, total, checked, toCheck, frame, milliseconds, verification, problem, cancelled);
    }

    RenderState at(int tiles, int of) {
        return new RenderState(plan, tiles, of, checked, toCheck, frame, fullTraceMs, verification, problem, cancelled);
    }

    RenderState checking(int tiles, int of) {
        return new RenderState(plan, done, total, tiles, of, frame, fullTraceMs, verification, null, false);
    }

    /** The last verdict goes where it is of another picture. */
    RenderState rendered(Frame picture) {
        Verification still = verification != null && verification.speaksOf(picture.promise()) ? verification : null;
        return new RenderState(plan, done, total, checked, toCheck, picture, fullTraceMs, still, problem, cancelled);
    }

    RenderState verified(Verification result) {
        return new RenderState(plan, done, total, 0, 0, frame, fullTraceMs, result, problem, cancelled);
    }

    RenderState stopped(Throwable why) {
        return new RenderState(plan, done, total, 0, 0, frame, fullTraceMs, verification, why, why == null);
    }
}
