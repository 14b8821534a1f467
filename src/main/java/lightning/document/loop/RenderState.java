package lightning.document.loop;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.plan.UpdatePlan;
import org.jspecify.annotations.Nullable;

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
 */
@RecordBuilder
public record RenderState(@Nullable UpdatePlan plan, int done, int total, int verifiedTiles, int tilesToVerify, @Nullable Frame frame,
        @Nullable WarmSaving measuredSaving,
        @Nullable Verification verification, @Nullable Throwable problem, boolean canceled, RenderActivity activity)
        implements RenderStateBuilder.With {
    public static final RenderState NONE = new RenderState(null, 0, 0, 0, 0, null, null, null, null, false, RenderActivity.NONE);

    /** Returns the progress, 0…1. */
    public double progress() {
        return total == 0 ? 0 : (double) done / total;
    }

    /** Returns the saving of the update that rendered the image; empty if unknown. */
    public Optional<WarmSaving> saving() {
        return Optional.ofNullable(measuredSaving).filter(m -> frame != null && m.isOf(frame.update()));
    }

    /** Sets the plan of an update that starts. */
    @Override
    public RenderState withPlan(UpdatePlan next) {
        return with(s -> s.plan(next).done(0).total(0).problem(null).canceled(false));
    }

    public RenderState withProgress(int tiles, int tileCount) {
        return with(s -> s.done(tiles).total(tileCount));
    }

    public RenderState withVerificationProgress(int tiles, int tileCount) {
        return with(s -> s.verifiedTiles(tiles).tilesToVerify(tileCount).problem(null).canceled(false));
    }

    /** Sets the image and drops a verification of another one. */
    @Override
    public RenderState withFrame(Frame newFrame) {
        Verification validVerification = verification != null && verification.appliesTo(newFrame.guarantee()) ? verification : null;
        return with(s -> s.frame(newFrame).verification(validVerification));
    }

    /** Sets the result of a verification, which has ended. */
    @Override
    public RenderState withVerification(Verification result) {
        return with(s -> s.verification(result).verifiedTiles(0).tilesToVerify(0));
    }

    /** Sets the failure of the last job, or that it was canceled if null. */
    public RenderState withStop(@Nullable Throwable failure) {
        return with(s -> s.verifiedTiles(0).tilesToVerify(0).problem(failure).canceled(failure == null));
    }
}
