package lightning.editor.loop;

import java.util.Optional;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.plan.UpdatePlan;

/**
 * State of the image and its renders.
 *
 * @param plan           plan of the running or last update; null before the first
 * @param done           finished tiles of {@code total}
 * @param total          tiles of the update
 * @param verifiedTiles  finished tiles of {@code tilesToVerify}, which is 0 if no verification runs
 * @param frame          last image; null before the first
 * @param measuredSaving saving of the last update or an older one; null if unknown
 * @param verification   last verification of this image or an equal one; null if none
 * @param problem        failure of the last job; null if it succeeded
 * @param canceled       whether the last job was canceled
 * @param activity       work since the current stage of the image started
 * @param addedIndirect  whether the update of the last image added indirect light to a picture of direct light
 */
public record RenderState(UpdatePlan plan, int done, int total, int verifiedTiles, int tilesToVerify, Frame frame,
        WarmSaving measuredSaving,
        Verification verification, Throwable problem, boolean canceled, RenderActivity activity, boolean addedIndirect) {
    public static final RenderState NONE = new RenderState(null, 0, 0, 0, 0, null, null, null, null, false, RenderActivity.NONE, false);

    /** Returns the progress, 0…1. */
    public double progress() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** Returns the saving of the update that rendered the image; empty if unknown. */
    public Optional<WarmSaving> saving() {
        return Optional.ofNullable(measuredSaving).filter(m -> frame != null && m.isOf(frame.update()));
    }

    public RenderState withPlan(UpdatePlan next) {
        return new RenderState(next, 0, 0, verifiedTiles, tilesToVerify, frame, measuredSaving, verification, null, false, activity,
                addedIndirect);
    }

    public RenderState withSaving(WarmSaving saving) {
        return new RenderState(plan, done, total, verifiedTiles, tilesToVerify, frame, saving, verification, problem, canceled, activity,
                addedIndirect);
    }

    public RenderState withActivity(RenderActivity now) {
        return new RenderState(plan, done, total, verifiedTiles, tilesToVerify, frame, measuredSaving, verification, problem, canceled,
                now, addedIndirect);
    }

    public RenderState withProgress(int tiles, int tileCount) {
        return new RenderState(plan, tiles, tileCount, verifiedTiles, tilesToVerify, frame, measuredSaving, verification, problem,
                canceled, activity, addedIndirect);
    }

    public RenderState withVerificationProgress(int tiles, int tileCount) {
        return new RenderState(plan, done, total, tiles, tileCount, frame, measuredSaving, verification, null, false, activity,
                addedIndirect);
    }

    /** Sets the image and drops a verification of another one. */
    public RenderState withFrame(Frame newFrame) {
        return withFrame(newFrame, false);
    }

    /**
     * Sets the image as {@link #withFrame(Frame)} does.
     *
     * @param wasIndirectAdded whether its update added indirect light to a picture of direct light
     */
    public RenderState withFrame(Frame newFrame, boolean wasIndirectAdded) {
        Verification validVerification = verification != null && verification.appliesTo(newFrame.guarantee()) ? verification : null;
        return new RenderState(plan, done, total, verifiedTiles, tilesToVerify, newFrame, measuredSaving, validVerification, problem,
                canceled, activity, wasIndirectAdded);
    }

    public RenderState withVerification(Verification result) {
        return new RenderState(plan, done, total, 0, 0, frame, measuredSaving, result, problem, canceled, activity, addedIndirect);
    }

    public RenderState withStop(Throwable failure) {
        return new RenderState(plan, done, total, 0, 0, frame, measuredSaving, verification, failure, failure == null, activity,
                addedIndirect);
    }
}
