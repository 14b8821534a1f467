package lightning.render.relight.tile;

import lightning.base.work.Progress;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.gather.PointChanges;
import lightning.render.image.Film;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.Geometry;
import lightning.render.trace.ShapeChange;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Shared, immutable data of one update for all threads.
 *
 * @param target       target scene of the first level
 * @param mirrorTarget target scene of the mirror levels: the same if they are updated too, and in a first pass
 * @param plan         the update; null in a first pass
 * @param indirectChange changed indirect light of the first level
 * @param mirroredIndirectChange changed indirect light of the mirror levels
 * @param fog fog of the target scene; null if its air is clear, or before it is computed
 * @param bounceFog fog along bounced rays of the target scene of mirrors; null if no light is seen there, or before it is computed
 * @param changesBounceFog whether it shows other light than in the last picture
 */
public record RenderJob(PreparedScene target, PreparedScene mirrorTarget, RenderOptions options, UpdatePlan.@Nullable Relight plan,
        Progress progress, IndirectChange indirectChange, IndirectChange mirroredIndirectChange, @Nullable PictureFog fog,
        @Nullable PictureFog bounceFog,
        boolean changesBounceFog) {

    private RenderJob(PreparedScene target, PreparedScene mirrorTarget, RenderOptions options, UpdatePlan.@Nullable Relight plan,
            Progress progress) {
        this(target, mirrorTarget, options, plan, progress, IndirectChange.NONE, IndirectChange.NONE, null, null, false);
    }

    /** Creates the job of a first pass. */
    public static RenderJob firstPass(Geometry geometry, Scene target, RenderOptions options, Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, target);
        return new RenderJob(shown, shown, options, null, progress);
    }

    /**
     * Creates the job of an update.
     *
     * @param geometry geometry of the target shapes
     * @param target   target scenes of the first level and the mirrors
     */
    public static RenderJob relight(UpdatePlan.Relight plan, Geometry geometry, RenderedScenes target, RenderOptions options,
            Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, target.scene());
        return new RenderJob(shown, plan.mirrors() == null ? PreparedScene.of(geometry, target.mirrored()) : shown, options, plan,
                progress);
    }

    /** Creates the job that traces samples for existing centers, whose mirrors may show an older scene. */
    public static RenderJob samples(PixelCache centers, RenderOptions options, Progress progress) {
        PreparedScene shown = PreparedScene.of(centers.geometry(), centers.scene());
        PreparedScene mirrored = centers.hasCurrentReflections() ? shown
                : PreparedScene.of(centers.geometry(), centers.mirrored().scene());
        return new RenderJob(shown, mirrored, options, null, progress);
    }

    /**
     * Returns this job with indirect light, each null if its scene has none.
     *
     * @param shown    indirect light of the target scene
     * @param mirrored indirect light of the scene that mirrors show
     * @param old      cache of the last picture
     * @param changes  change of the gather points of the target scene since the last picture
     */
    RenderJob withIndirect(@Nullable IndirectCache shown, @Nullable IndirectCache mirrored, @Nullable PixelCache old,
            @Nullable PointChanges changes) {
        IndirectLight shownLight = light(shown);
        IndirectLight mirroredLight = light(mirrored);
        IndirectLight shownBefore = old == null ? null : light(old.indirect());
        IndirectLight mirroredBefore = old == null ? null : light(old.mirrored().indirect());
        PreparedScene top = target.withIndirect(shownLight, changes);
        IndirectChange change = IndirectChange.between(shownBefore, shownLight);
        return new RenderJob(top, mirrorTarget == target ? top : mirrorTarget.withIndirect(mirroredLight, null), options, plan, progress,
                change,
                mirroredBefore == shownBefore && mirroredLight == shownLight ? change
                        : IndirectChange.between(mirroredBefore, mirroredLight),
                fog, bounceFog, changesBounceFog);
    }

    private static @Nullable IndirectLight light(@Nullable IndirectCache indirect) {
        return indirect == null ? null : indirect.light();
    }

    /** Returns this job with another progress. */
    RenderJob withProgress(Progress v) {
        return new RenderJob(target, mirrorTarget, options, plan, v, indirectChange, mirroredIndirectChange, fog, bounceFog,
                changesBounceFog);
    }

    /** Returns this job with the fog of the target scene. */
    RenderJob withFog(@Nullable PictureFog v) {
        return new RenderJob(target, mirrorTarget, options, plan, progress, indirectChange, mirroredIndirectChange, v, bounceFog,
                changesBounceFog);
    }

    /**
     * Returns this job with fog along bounced rays.
     *
     * @param changed whether it shows other light than in the last picture
     */
    RenderJob withBounceFog(@Nullable PictureFog v, boolean changed) {
        return new RenderJob(target, mirrorTarget, options, plan, progress, indirectChange, mirroredIndirectChange, fog, v, changed);
    }

    /** Returns whether fog may have another color although none of its light changes: a weight of a light changed. */
    boolean reweightsFog() {
        return fog != null && plan != null && plan.top().layers().stream().anyMatch(LayerPlan::changesImage);
    }

    /** Returns whether the scene has finer samples only at edges. */
    public static boolean needsEdges(Scene scene) {
        return scene.picture().sampling().antialias() == AntialiasMode.EDGES;
    }

    /** Returns whether anti-aliasing detects edges. */
    boolean detectsEdges() {
        return needsEdges(scene());
    }

    Scene scene() {
        return target.scene();
    }

    /** Returns the update of the first level; null in a first pass. */
    @Nullable
    LevelPlan topPlan() {
        return plan == null ? null : plan.top();
    }

    /** Returns the update of the mirror levels; null if they stay unchanged, and in a first pass. */
    @Nullable
    LevelPlan mirrorPlan() {
        return plan == null ? null : plan.mirrors();
    }

    /** Returns the change of the shapes. */
    ShapeChange shapeChange() {
        return plan == null ? ShapeChange.NONE : plan.shapes();
    }

    /** Returns whether mirror levels are stored as full rows. */
    boolean storesMirrorRows() {
        return options.storesMirrorRows();
    }

    /** Returns whether rows must store their owner shapes. */
    boolean needsOwners() {
        return WeightedLight.needOwners(target.lights()) || WeightedLight.needOwners(mirrorTarget.lights());
    }

    int depth() {
        return scene().picture().depth();
    }

    /** Returns the recursion depth of the previous picture; in a first pass that of the scene. */
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
