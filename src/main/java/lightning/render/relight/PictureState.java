package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.UpdateMethod;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.RenderJob;
import org.jspecify.annotations.Nullable;

/** State of a renderer's picture. Immutable: an update makes the next state, and the renderer replaces its state in one assignment. */
public sealed interface PictureState {

    /** No picture. */
    record Empty() implements PictureState {}

    /**
     * Pixel centers, exact, without the finer samples at edges.
     *
     * @param samples what the samples will be rendered from
     */
    record CentersOnly(PixelCache centers, PendingSamples samples) implements PictureState {}

    /**
     * A picture with all samples that its scene requires.
     *
     * @param method method of its layers; it differs from the renderer's options after a change, until the next update
     */
    record Finished(PixelCache cache, UpdateMethod method) implements PictureState {}

    /** Returns whether no sample is missing that the scene requires; true without a picture. */
    default boolean isFinished() {
        return !(this instanceof CentersOnly);
    }

    /** Returns whether there is a picture. */
    default boolean hasPicture() {
        return !(this instanceof Empty);
    }

    /** Returns the state that shows a cache, with or without its finer samples, or no picture if it is null. */
    static PictureState of(@Nullable PixelCache saved, UpdateMethod method) {
        if (saved == null) {
            return new Empty();
        }
        boolean hasSamples = saved.fineCount() > 0 || !RenderJob.needsEdges(saved.scene());
        return hasSamples ? new Finished(saved, method)
                : new CentersOnly(saved, new PendingSamples(null, new UpdatePlan.Nothing()));
    }

    /** Returns the cache of the newest picture; null if there is none. */
    default @Nullable PixelCache newest() {
        return switch (this) {
            case Empty _ -> null;
            case CentersOnly unfinished -> unfinished.centers();
            case Finished picture -> picture.cache();
        };
    }

    /** Returns the cache of the newest picture of a state that is not empty. */
    default PixelCache picture() {
        return requireNonNull(newest());
    }

    /** Returns the cache of the last picture with all its samples; null if there is none. */
    default @Nullable PixelCache lastFinished() {
        return switch (this) {
            case Empty _ -> null;
            case CentersOnly unfinished -> unfinished.samples().finishedCache();
            case Finished picture -> picture.cache();
        };
    }

    /** Returns the bytes of all cached data. */
    default long bytes() {
        PixelCache newest = newest();
        PixelCache finished = lastFinished();
        return (newest == null ? 0 : MemoryEstimate.usedBytes(newest))
                + (finished == null || finished == newest ? 0 : MemoryEstimate.usedBytes(finished));
    }

    /** Returns whether its layers must be converted before an update with this method. */
    default boolean needsConversion(UpdateMethod to) {
        return this instanceof Finished picture && !picture.method().equals(to);
    }
}
