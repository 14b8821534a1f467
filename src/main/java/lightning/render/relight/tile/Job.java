package lightning.render.relight.tile;

import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.Luminaire;
import lightning.render.shading.SeenScenes;
import lightning.render.trace.Geometry;
import lightning.render.trace.ShapeChange;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/**
 * What all threads of one update share, made ready once.
 *
 * @param shown    what the first level shall show
 * @param mirrored what the mirror levels shall show: the same where they are updated too, and in a first pass
 * @param plan     the update; null in a first pass
 * @param coding   whether anti-aliasing looks for edges
 */
public record Job(PreparedScene shown, PreparedScene mirrored, Options options, UpdatePlan.Relight plan, boolean coding,
        Progress progress) {

    /** A picture from nothing. */
    public static Job firstPass(Geometry geometry, Scene wanted, Options options, Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, wanted);
        return new Job(shown, shown, options, null, seeksEdges(wanted), progress);
    }

    /**
     * An update.
     *
     * @param geometry of the shapes wanted
     * @param wanted   what the first level and the mirrors shall show
     */
    public static Job relight(UpdatePlan.Relight plan, Geometry geometry, SeenScenes wanted, Options options, Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, wanted.scene());
        return new Job(shown, plan.mirrors() == null ? PreparedScene.of(geometry, wanted.mirrored()) : shown, options, plan,
                seeksEdges(wanted.scene()), progress);
    }

    /** Samples from nothing, of centres that may have mirrors of an older scene. */
    public static Job samples(PixelCache centers, Options options, Progress progress) {
        PreparedScene shown = PreparedScene.of(centers.geometry(), centers.scene());
        PreparedScene mirrored = centers.mirroredScene().equals(centers.scene()) ? shown
                : PreparedScene.of(centers.geometry(), centers.mirroredScene());
        return new Job(shown, mirrored, options, null, true, progress);
    }

    /** Whether the scene has finer samples where there are edges. */
    public static boolean seeksEdges(Scene scene) {
        return scene.picture().sampling().antialias() == Antialias.EDGES;
    }

    Scene scene() {
        return shown.scene();
    }

    /** The update of the first level; null in a first pass. */
    LevelPlan top() {
        return plan == null ? null : plan.top();
    }

    /** The update of the mirror levels; null where they stay, and in a first pass. */
    LevelPlan mirrors() {
        return plan == null ? null : plan.mirrors();
    }

    /** What became of the shapes. */
    ShapeChange shapes() {
        return plan == null ? ShapeChange.NONE : plan.shapes();
    }

    /** Whether mirror levels are kept as full rows. */
    boolean keepsRows() {
        return options.storage().keepsRows();
    }

    /** Whether rows must know whose they are. */
    boolean owned() {
        return Luminaire.anyLinked(shown.lights()) || Luminaire.anyLinked(mirrored.lights());
    }

    int depth() {
        return scene().picture().depth();
    }

    /** The depth of the picture before; that of the scene in a first pass. */
    int depthBefore() {
        return plan == null ? depth() : plan.depthFrom();
    }

    Sampling sampling() {
        return scene().picture().sampling();
    }

    int tilesX() {
        return Film.tilesAlong(scene().picture().width());
    }

    int tileCount() {
        return tilesX() * Film.tilesAlong(scene().picture().height());
    }
}
