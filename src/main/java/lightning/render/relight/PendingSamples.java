package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.List;
import lightning.render.cache.CachedLight;
import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.ExactMethod;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdateMethod;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.WorkCounts;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Finer samples that a picture of pixel centers still lacks. They are not updated with every update of the centers, but in one step
 * from the last picture that had its samples.
 *
 * @param finishedCache cache of that picture; null if there is none to start from, and samples are traced from nothing
 * @param plan          plan of the first update since; of the newest update if there is no such picture
 * @param deferredWork  work of all updates since that picture
 * @param nanoseconds   time of all updates since that picture
 */
record PendingSamples(@Nullable PixelCache finishedCache, UpdatePlan plan, WorkCounts deferredWork, long nanoseconds) {
    /** Samples can be deferred only if nothing is scaled. */
    private static final UpdateMethod EXACT = new ExactMethod();

    /** Creates the state before any update. */
    PendingSamples(@Nullable PixelCache finished, UpdatePlan plan) {
        this(finished, plan, WorkCounts.NONE, 0);
    }

    /**
     * Returns the pending samples after one more update. A picture that never had samples starts again, because its time was
     * already reported.
     */
    PendingSamples afterUpdate(UpdatePlan update) {
        return finishedCache == null ? new PendingSamples(null, update) : this;
    }

    PendingSamples plus(WorkCounts more, long time) {
        return new PendingSamples(finishedCache, plan, deferredWork.plus(more), nanoseconds + time);
    }

    /**
     * Start of an update and its plan.
     *
     * @param from the newest picture, or the finished one before it
     */
    record Start(@Nullable PixelCache from, UpdatePlan plan) {}

    /**
     * Chooses the start of an update: the cached centers, or the finished picture if the samples could not follow otherwise.
     *
     * <p>The samples can follow if both starts lead to layers computed for the same lights. A light that changed and was then
     * switched off leaves older layers in the centers. Both starts must also lead to the same reflections: if a depth change
     * recomputes them, they show the target scene, but the finished picture may already have the target depth and then keeps its
     * reflections.
     *
     * @param centers cache of the newest picture, centers only
     * @param mirrors true if mirror images must show the target scene too
     */
    Start chooseStart(PixelCache centers, Scene target, boolean mirrors) {
        UpdatePlan fromCenters = Dispatcher.plan(centers, target, mirrors, EXACT);
        Start continued = new Start(centers, fromCenters);
        if (finishedCache == null || !(fromCenters instanceof UpdatePlan.Relight next) || next.resampled()
                || !canReuseMirrors(centers, next, target)) {
            return continued;
        }
        UpdatePlan fromWhole = Dispatcher.plan(finishedCache, target, mirroredScene(centers, next, target).equals(target), EXACT);
        return fromWhole instanceof UpdatePlan.Relight all && leadToSameLights(centers, next, all) ? continued
                : new Start(finishedCache, fromWhole);
    }

    /** Returns the scene that mirrors show after an update of the centers. */
    private static Scene mirroredScene(PixelCache centers, UpdatePlan.Relight next, Scene target) {
        return next.mirrors() == null ? centers.mirrored().scene() : target;
    }

    /**
     * Returns whether one update leads from the finished picture to the reflections that an update of the centers would show. It
     * does not if a depth change recomputed them between two edits that keep reflections.
     */
    boolean canReuseMirrors(PixelCache centers, UpdatePlan.Relight next, Scene target) {
        Scene mirrored = mirroredScene(centers, next, target);
        return finishedCache == null || mirrored.equals(target)
                || mirrored.equals(finishedCache.mirrored().scene()) && finishedCache.scene().picture().depth() == target.picture().depth();
    }

    /** Returns the plan from the finished picture to these centers; the newest update if there is none. */
    UpdatePlan plan(PixelCache centers) {
        return finishedCache == null ? plan
                : Dispatcher.plan(finishedCache, centers.scene(), centers.geometry(), centers.hasCurrentReflections(),
                        EXACT);
    }

    private boolean leadToSameLights(PixelCache centers, UpdatePlan.Relight next, UpdatePlan.Relight all) {
        return next.top().lightsAfter(EXACT, 1).equals(all.top().lightsAfter(EXACT, 1))
                && mirroredLights(centers, next.mirrors()).equals(mirroredLights(requireNonNull(finishedCache), all.mirrors()));
    }

    private static List<CachedLight> mirroredLights(PixelCache from, @Nullable LevelPlan plan) {
        return plan == null ? from.mirrored().lights() : plan.lightsAfter(EXACT, 1);
    }
}
