package lightning.render.relight;

import java.util.List;
import lightning.render.cache.CachedLight;
import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdateMethod;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.ExactMethod;
import lightning.render.relight.tile.WorkCounts;
import lightning.scene.Scene;

/**
 * What a picture of pixels' centers still lacks: its finer samples. They are not made of the samples of the centers' own updates,
 * which may have been several, but at once of those of the last picture that had its samples.
 *
 * @param finishedCache       that picture; null where there is none that serves, and samples are traced from nothing
 * @param plan        of the first update since; where there is none such, of the newest
 * @param deferredWork        of all updates since that one
 * @param nanoseconds likewise
 */
record PendingSamples(PixelCache finishedCache, UpdatePlan plan, WorkCounts deferredWork, long nanoseconds) {
    /** Samples follow where nothing is scaled. */
    private static final UpdateMethod EXACT = new ExactMethod();

    /** Nothing was done yet. */
    PendingSamples(PixelCache finished, UpdatePlan plan) {
        this(finished, plan, WorkCounts.NONE, 0);
    }

    /** What is lacking after one more update: what there was of a picture that never had samples, and its time, was told by itself. */
    PendingSamples afterUpdate(UpdatePlan update) {
        return finishedCache == null ? new PendingSamples(null, update) : this;
    }

    PendingSamples plus(WorkCounts more, long time) {
        return new PendingSamples(finishedCache, plan, deferredWork.plus(more), nanoseconds + time);
    }

    /**
     * What an update goes on from, and how.
     *
     * @param from the newest picture, or the whole one before it
     */
    record Start(PixelCache from, UpdatePlan plan) {}

    /**
     * How an update gets to a scene: from the centers known, or, where the samples could then not follow, from the whole picture.
     * They follow where both ways lead to layers that were computed for the same lights: a light that changed and then ceased to
     * shine leaves older layers behind. Both ways lead to the same mirrors: where a change of depth makes them anew they show the
     * wanted scene, though the whole picture may have the wanted depth already, and no reason of its own to touch them.
     *
     * @param centers the newest picture, of centers alone
     * @param mirrors whether mirror images shall show the wanted scene too
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

    /** What mirrors show after an update of the centers. */
    private static Scene mirroredScene(PixelCache centers, UpdatePlan.Relight next, Scene target) {
        return next.mirrors() == null ? centers.mirroredScene() : target;
    }

    /**
     * Whether one update leads from the whole picture to mirrors that show what they do after an update of the centers. It does not
     * where a change of depth made them anew between two edits that leave mirrors alone.
     */
    boolean canReuseMirrors(PixelCache centers, UpdatePlan.Relight next, Scene target) {
        Scene mirrored = mirroredScene(centers, next, target);
        return finishedCache == null || mirrored.equals(target)
                || mirrored.equals(finishedCache.mirroredScene()) && finishedCache.scene().picture().depth() == target.picture().depth();
    }

    /** What leads from that picture to these centers; of the newest update where there is none. */
    UpdatePlan plan(PixelCache centers) {
        return finishedCache == null ? plan
                : Dispatcher.plan(finishedCache, centers.scene(), centers.geometry(), centers.mirroredScene().equals(centers.scene()),
                        EXACT);
    }

    private boolean leadToSameLights(PixelCache centers, UpdatePlan.Relight next, UpdatePlan.Relight all) {
        return next.top().lightsAfter(EXACT, 1).equals(all.top().lightsAfter(EXACT, 1))
                && mirroredLights(centers, next.mirrors()).equals(mirroredLights(finishedCache, all.mirrors()));
    }

    private static List<CachedLight> mirroredLights(PixelCache from, LevelPlan plan) {
        return plan == null ? from.mirroredLights() : plan.lightsAfter(EXACT, 1);
    }
}
