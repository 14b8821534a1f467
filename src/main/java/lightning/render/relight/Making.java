package lightning.render.relight;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineTile;
import lightning.render.cache.KnownLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Job;
import lightning.render.relight.tile.LevelJob;
import lightning.render.relight.tile.Options;
import lightning.render.relight.tile.PreparedScene;
import lightning.render.relight.tile.RepeatedEdit;
import lightning.render.relight.tile.Tally;
import lightning.render.relight.tile.TileRun;
import lightning.render.shading.Luminaire;
import lightning.render.shading.SeenScenes;
import lightning.render.trace.Geometry;
import lightning.render.trace.ShapeChange;
import lightning.scene.Antialias;
import lightning.scene.Scene;

/**
 * Makes what is kept of a picture: from nothing or from an older one; all of it, its pixels' centres alone, or the finer samples of
 * centres that are known. All throw {@link CancellationException} if the progress asked to stop.
 */
record Making(Options options, Workers workers, Progress progress) {

    /**
     * What was made.
     *
     * @param work what that took
     */
    record Made(PixelCache cache, Tally work) {}

    /** Which light is edited again and again, in what the eye sees and in mirrors. */
    record Repeats(RepeatedEdit top, RepeatedEdit mirrors) {
        Repeats() {
            this(new RepeatedEdit(), new RepeatedEdit());
        }

        void end() {
            top.end();
            mirrors.end();
        }
    }

    /** Whether the scene has finer samples where there are edges. */
    static boolean seeksEdges(Scene scene) {
        return scene.picture().sampling().antialias() == Antialias.EDGES;
    }

    /** From nothing. */
    Made firstPass(Geometry geometry, Scene wanted, boolean centersAlone) {
        PreparedScene shown = PreparedScene.of(geometry, wanted);
        List<KnownLight> lights = KnownLight.all(wanted, light -> Luminaire.of(light, wanted).isDark() ? null : LayerStamp.fresh(light));
        TileRun run =
                new TileRun(new Job(shown, shown, options, null, null, ShapeChange.NONE, wanted.picture().depth(), seeksEdges(wanted),
                        progress), workers, null);
        Tiles tiles = Tiles.of(run, centersAlone);
        return new Made(new PixelCache(shown.geometry(), tiles.centers, tiles.fine, SeenScenes.of(wanted), lights, lights), run.work());
    }

    /** As planned from an older picture. */
    Made relight(UpdatePlan.Relight plan, PixelCache old, Scene wanted, Repeats repeats, boolean centersAlone) {
        var scenes = new SeenScenes(wanted, plan.mirrors() == null ? old.mirroredScene() : wanted);
        Job job = job(plan, old, plan.shapes().after(old.geometry()), scenes, repeats);
        TileRun run = new TileRun(job, workers, old);
        Tiles tiles = Tiles.of(run, centersAlone);
        boolean scaled = options.accuracy() == Accuracy.RATIO;
        return new Made(new PixelCache(job.shown().geometry(), tiles.centers, tiles.fine, scenes,
                plan.top().after(scaled, run.leastFalloff()),
                plan.mirrors() == null ? old.mirroredLights() : plan.mirrors().after(scaled, run.leastFalloff())), run.work());
    }

    /**
     * The finer samples of known centres.
     *
     * @param whole an older picture with its samples, from which they follow; null for none
     * @param plan  what leads from that to the centres' scenes
     */
    Made samples(PixelCache centers, PixelCache whole, UpdatePlan plan) {
        TileRun run = whole != null && plan instanceof UpdatePlan.Relight relight
                ? new TileRun(job(relight, whole, centers.geometry(), centers.scenes(), new Repeats()), workers, whole)
                : new TileRun(fresh(centers), workers, null);
        return new Made(new PixelCache(centers.geometry(), centers.tiles(), run.samples(centers.tiles(), 0), centers.scenes(),
                centers.lights(), centers.mirroredLights()), run.work());
    }

    private Job job(UpdatePlan.Relight plan, PixelCache old, Geometry geometry, SeenScenes wanted, Repeats repeats) {
        PreparedScene shown = PreparedScene.of(geometry, wanted.scene());
        LevelJob top = LevelJob.of(plan.top(), plan.shapes(), old.scene(), shown.lights(), repeats.top);
        boolean coding = seeksEdges(wanted.scene());
        return plan.mirrors() == null
                ? new Job(shown, PreparedScene.of(geometry, wanted.mirrored()), options, top, null, plan.shapes(), plan.depthFrom(), coding,
                        progress)
                : new Job(shown, shown, options, top,
                        LevelJob.of(plan.mirrors(), plan.shapes(), old.mirroredScene(), shown.lights(), repeats.mirrors), plan.shapes(),
                        plan.depthFrom(), coding, progress);
    }

    /** Samples that follow from nothing, of centres that may have mirrors of an older scene. */
    private Job fresh(PixelCache centers) {
        PreparedScene shown = PreparedScene.of(centers.geometry(), centers.scene());
        PreparedScene mirrored = centers.mirroredScene().equals(centers.scene()) ? shown
                : PreparedScene.of(centers.geometry(), centers.mirroredScene());
        return new Job(shown, mirrored, options, null, null, ShapeChange.NONE, centers.scene().picture().depth(), true, progress);
    }

    private record Tiles(CachedTile[] centers, FineTile[] fine) {
        // Arrays in a record: written once by their maker, never after.

        static Tiles of(TileRun run, boolean centersAlone) {
            CachedTile[] centers = run.centers(centersAlone ? 0 : run.fineTiles());
            return new Tiles(centers, centersAlone ? new FineTile[0] : run.samples(centers, centers.length));
        }
    }
}
