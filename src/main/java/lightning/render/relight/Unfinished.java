package lightning.render.relight;

import java.util.List;
import lightning.render.cache.KnownLight;
import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdateMethod;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.ExactMethod;
import lightning.render.relight.tile.Tally;
import lightning.scene.Scene;

/**
 * What a picture of pixels' centres still lacks: its finer samples. They are not made of the samples of the centres' own updates,
 * which may have been several, but at once of those of the last picture that had its samples.
 *
 * @param whole       that picture; null where there is none that serves, and samples are traced from nothing
 * @param plan        of the first update since; where there is none such, of the newest
 * @param work        of all updates since that one
 * @param nanoseconds likewise
 */
record Unfinished(PixelCache whole, UpdatePlan plan, Tally work, long nanoseconds) {
    /** Samples follow where nothing is scaled. */
    private static final UpdateMethod EXACT = new ExactMethod();

    /** Nothing was done yet. */
    Unfinished(PixelCache whole, UpdatePlan plan) {
        this(whole, plan, Tally.NONE, 0);
    }

    /** What is lacking after one more update: what there was of a picture that never had samples, and its time, was told by itself. */
    Unfinished next(UpdatePlan update) {
        return whole == null ? new Unfinished(null, update) : this;
    }

    Unfinished plus(Tally more, long time) {
        return new Unfinished(whole, plan, work.plus(more), nanoseconds + time);
    }

    /**
     * What an update goes on from, and how.
     *
     * @param from the newest picture, or the whole one before it
     */
    record Start(PixelCache from, UpdatePlan plan) {}

    /**
     * How an update gets to a scene: from the centres known, or, where the samples could then not follow, from the whole picture.
     * They follow where both ways lead to layers that were computed for the same lights: a light that changed and then ceased to
     * shine leaves older layers behind. Both ways lead to the same mirrors: where a change of depth makes them anew they show the
     * wanted scene, though the whole picture may have the wanted depth already, and no reason of its own to touch them.
     *
     * @param centers the newest picture, of centres alone
     * @param mirrors whether mirror images shall show the wanted scene too
     */
    Start start(PixelCache centers, Scene wanted, boolean mirrors) {
        UpdatePlan fromCenters = Dispatcher.plan(centers, wanted, mirrors, EXACT);
        Start goesOn = new Start(centers, fromCenters);
        if (whole == null || !(fromCenters instanceof UpdatePlan.Relight next) || next.resampled()
                || !mirrorsFollow(centers, next, wanted)) {
            return goesOn;
        }
        UpdatePlan fromWhole = Dispatcher.plan(whole, wanted, mirrored(centers, next, wanted).equals(wanted), EXACT);
        return fromWhole instanceof UpdatePlan.Relight all && leadAlike(centers, next, all) ? goesOn : new Start(whole, fromWhole);
    }

    /** What mirrors show after an update of the centres. */
    private static Scene mirrored(PixelCache centers, UpdatePlan.Relight next, Scene wanted) {
        return next.mirrors() == null ? centers.mirroredScene() : wanted;
    }

    /**
     * Whether one update leads from the whole picture to mirrors that show what they do after an update of the centres. It does not
     * where a change of depth made them anew between two edits that leave mirrors alone.
     */
    boolean mirrorsFollow(PixelCache centers, UpdatePlan.Relight next, Scene wanted) {
        Scene mirrored = mirrored(centers, next, wanted);
        return whole == null || mirrored.equals(wanted)
                || mirrored.equals(whole.mirroredScene()) && whole.scene().picture().depth() == wanted.picture().depth();
    }

    /** What leads from that picture to these centres; of the newest update where there is none. */
    UpdatePlan plan(PixelCache centers) {
        return whole == null ? plan
                : Dispatcher.plan(whole, centers.scene(), centers.geometry(), centers.mirroredScene().equals(centers.scene()),
                        EXACT);
    }

    private boolean leadAlike(PixelCache centers, UpdatePlan.Relight next, UpdatePlan.Relight all) {
        return next.top().after(EXACT, 1).equals(all.top().after(EXACT, 1))
                && mirrored(centers, next.mirrors()).equals(mirrored(whole, all.mirrors()));
    }

    private static List<KnownLight> mirrored(PixelCache from, LevelPlan plan) {
        return plan == null ? from.mirroredLights() : plan.after(EXACT, 1);
    }
}
