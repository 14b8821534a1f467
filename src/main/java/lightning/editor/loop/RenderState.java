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
 * @param verifiedTiles      tiles of the verification finished; likewise {@code tilesToVerify}, 0 where none runs
 * @param frame        the last picture; null before the first
 * @param measuredSaving     what an update saves, that of the last picture or an older one; null while nothing is known
 * @param verification the last one that ended since the picture came, or of the same; null where there is none
 * @param problem      why the last work failed; null if it did not
 * @param canceled    whether the last work ended before its time
 */
public record RenderState(UpdatePlan plan, int done, int total, int verifiedTiles, int tilesToVerify, Frame frame,
        WarmSaving measuredSaving,
        Verification verification, Throwable problem, boolean canceled) {
    public static final RenderState NONE = new RenderState(null, 0, 0, 0, 0, null, null, null, null, false);

    /** 0…1. */
    public double progress() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** What the update that made the picture saves; empty while that is not known. */
    public Optional<WarmSaving> saving() {
        return Optional.ofNullable(measuredSaving).filter(m -> frame != null && m.isOf(frame.update()));
    }

    public RenderState withPlan(UpdatePlan next) {
        return new RenderState(next, 0, 0, verifiedTiles, tilesToVerify, frame, measuredSaving, verification, null, false);
    }

    public RenderState withSaving(WarmSaving saving) {
        return new RenderState(plan, done, total, verifiedTiles, tilesToVerify, frame, saving, verification, problem, canceled);
    }

    public RenderState withProgress(int tiles, int tileCount) {
        return new RenderState(plan, tiles, tileCount, verifiedTiles, tilesToVerify, frame, measuredSaving, verification, problem,
                canceled);
    }

    public RenderState withVerificationProgress(int tiles, int tileCount) {
        return new RenderState(plan, done, total, tiles, tileCount, frame, measuredSaving, verification, null, false);
    }

    /** The last verdict goes where it is of another picture. */
    public RenderState withFrame(Frame newFrame) {
        Verification validVerification = verification != null && verification.appliesTo(newFrame.guarantee()) ? verification : null;
        return new RenderState(plan, done, total, verifiedTiles, tilesToVerify, newFrame, measuredSaving, validVerification, problem,
                canceled);
    }

    public RenderState withVerification(Verification result) {
        return new RenderState(plan, done, total, 0, 0, frame, measuredSaving, result, problem, canceled);
    }

    public RenderState withStop(Throwable failure) {
        return new RenderState(plan, done, total, 0, 0, frame, measuredSaving, verification, failure, failure == null);
    }
}
