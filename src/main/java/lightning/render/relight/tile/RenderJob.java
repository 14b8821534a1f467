package lightning.render.relight.tile;

import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.render.trace.ShapeChange;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * What all threads of one update share, made ready once.
 *
 * @param target    what the first level shall show
 * @param mirrorTarget what the mirror levels shall show: the same where they are updated too, and in a first pass
 * @param plan     the update; null in a first pass
 * @param detectsEdges   whether anti-aliasing looks for edges
 */
public record RenderJob(PreparedScene target, PreparedScene mirrorTarget, RenderOptions options, UpdatePlan.Relight plan,
        boolean detectsEdges,
        Progress progress) {

    /** A picture from nothing. */
    public static RenderJob firstPass(Geometry geometry, Scene target, RenderOptions options, Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, target);
        return new RenderJob(shown, shown, options, null, needsEdges(target), progress);
    }

    /**
     * An update.
     *
     * @param geometry of the shapes wanted
     * @param target   what the first level and the mirrors shall show
     */
    public static RenderJob relight(UpdatePlan.Relight plan, Geometry geometry, RenderedScenes target, RenderOptions options,
            Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, target.scene());
        return new RenderJob(shown, plan.mirrors() == null ? PreparedScene.of(geometry, target.mirrored()) : shown, options, plan,
                needsEdges(target.scene()), progress);
    }

    /** Samples from nothing, of centers that may have mirrors of an older scene. */
    public static RenderJob samples(PixelCache centers, RenderOptions options, Progress progress) {
        PreparedScene shown = PreparedScene.of(centers.geometry(), centers.scene());
        PreparedScene mirrored = centers.mirroredScene().equals(centers.scene()) ? shown
                : PreparedScene.of(centers.geometry(), centers.mirroredScene());
        return new RenderJob(shown, mirrored, options, null, true, progress);
    }

    /** Whether the scene has finer samples where there are edges. */
    public static boolean needsEdges(Scene scene) {
        return scene.picture().sampling().antialias() == AntialiasMode.EDGES;
    }

    Scene scene() {
        return target.scene();
    }

    /** The update of the first level; null in a first pass. */
    LevelPlan topPlan() {
        return plan == null ? null : plan.top();
    }

    /** The update of the mirror levels; null where they stay, and in a first pass. */
    LevelPlan mirrorPlan() {
        return plan == null ? null : plan.mirrors();
    }

    /** What became of the shapes. */
    ShapeChange shapeChange() {
        return plan == null ? ShapeChange.NONE : plan.shapes();
    }

    /** Whether mirror levels are kept as full rows. */
    boolean storesMirrorRows() {
        return options.storage().storesRows();
    }

    /** Whether rows must know whose they are. */
    boolean needsOwners() {
        return WeightedLight.hasLinked(target.lights()) || WeightedLight.hasLinked(mirrorTarget.lights());
    }

    int depth() {
        return scene().picture().depth();
    }

    /** The depth of the picture before; that of the scene in a first pass. */
    int depthBefore() {
        return plan == null ? depth() : plan.oldDepth();
    }

    SamplingSettings sampling() {
        return scene().picture().sampling();
    }

    int tilesX() {
        return Film.tilesAlong(scene().picture().width());
    }

    int tileCount() {
        return tilesX() * Film.tilesAlong(scene().picture().height());
    }
}
