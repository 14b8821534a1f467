package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.gather.PointChanges;
import lightning.render.image.Film;
import lightning.render.relight.plan.FilmUpdate;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.FilmParts;
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
 * @param mirrorTarget target scene of the mirror levels: the same if they are updated too or look the same, and in a first pass
 * @param mirroredScene scene that the mirror levels were last updated to
 * @param plan         the update; null in a first pass
 * @param films        change of the films
 * @param mirroredFilms change of the films of the mirror levels
 * @param togglesMirrors whether mirrors begin or cease to show an earlier scene, so that other films contain what they show
 * @param indirectChange changed indirect light of the first level
 * @param mirroredIndirectChange changed indirect light of the mirror levels
 * @param fog fog of the target scene; null if its air is clear, or before it is computed
 * @param bounceFog fog along bounced rays of the target scene of mirrors; null if no light is seen there, or before it is computed
 * @param changesBounceFog whether it shows other light than in the last picture
 * @param onlyReweights whether nothing but weights of known films changes, and edges do not
 * @param keepsFilms    whether tiles store their films
 */
@RecordBuilder
public record RenderJob(PreparedScene target, PreparedScene mirrorTarget, Scene mirroredScene, RenderOptions options,
        UpdatePlan.@Nullable Relight plan,
        Progress progress, FilmUpdate films, FilmUpdate mirroredFilms, boolean togglesMirrors,
        IndirectChange indirectChange, IndirectChange mirroredIndirectChange, @Nullable PictureFog fog,
        @Nullable PictureFog bounceFog,
        boolean changesBounceFog, boolean onlyReweights, boolean keepsFilms) implements RenderJobBuilder.With {

    private static RenderJob of(PreparedScene target, PreparedScene mirrorTarget, Scene mirroredScene, RenderOptions options,
            UpdatePlan.@Nullable Relight plan, Progress progress, FilmUpdate films, FilmUpdate mirroredFilms) {
        return new RenderJob(target, mirrorTarget, mirroredScene, options, plan, progress, films, mirroredFilms, false, IndirectChange.NONE,
                IndirectChange.NONE,
                null, null, false, false, false);
    }

    /** Creates the job of a first pass. */
    public static RenderJob firstPass(Geometry geometry, Scene target, RenderOptions options, Progress progress) {
        PreparedScene shown = PreparedScene.of(geometry, target, !options.method().isExact());
        FilmUpdate first = FilmUpdate.first(shown.parts());
        return of(shown, shown, target, options, null, progress, first, first);
    }

    /**
     * Creates the job of an update.
     *
     * @param old      the last picture
     * @param geometry geometry of the target shapes
     * @param target   target scenes of the first level and the mirrors
     */
    public static RenderJob relight(UpdatePlan.Relight plan, PixelCache old, Geometry geometry, RenderedScenes target,
            RenderOptions options, Progress progress) {
        boolean isWeighted = !options.method().isExact();
        PreparedScene shown = PreparedScene.of(geometry, target.scene(), isWeighted);
        PreparedScene mirrored = target.areReflectionsCurrent() ? shown : PreparedScene.of(geometry, target.mirrored(), isWeighted);
        FilmUpdate films = FilmUpdate.between(FilmParts.of(old.scene(), isWeighted), shown.parts(), plan.top());
        boolean areMirrorsSame = !old.areMirrorsOutdated() && mirrored == shown;
        FilmUpdate inMirrors = areMirrorsSame ? films : plan.mirrors() == null ? FilmUpdate.none(mirrored.parts())
                : FilmUpdate.between(FilmParts.of(old.mirrored().scene(), isWeighted), mirrored.parts(), plan.mirrors());
        return of(shown, mirrored, target.mirrored(), options, plan, progress, films, inMirrors)
                .withTogglesMirrors(old.areMirrorsOutdated() == (mirrored == shown));
    }

    /** Creates the job that traces samples for existing centers, whose mirrors may show an older scene. */
    public static RenderJob samples(PixelCache centers, RenderOptions options, Progress progress) {
        PreparedScene shown = PreparedScene.of(centers.geometry(), centers.scene(), !options.method().isExact());
        PreparedScene mirrored = !centers.areMirrorsOutdated() ? shown
                : PreparedScene.of(centers.geometry(), centers.mirrored().scene(), !options.method().isExact());
        return of(shown, mirrored, centers.mirrored().scene(), options, null, progress, FilmUpdate.first(shown.parts()),
                FilmUpdate.first(mirrored.parts()));
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
        IndirectChange change = IndirectChange.between(shownBefore, shownLight, films);
        IndirectChange inMirrors = mirroredBefore == shownBefore && mirroredLight == shownLight ? change
                : IndirectChange.between(mirroredBefore, mirroredLight, mirroredFilms);
        PreparedScene below = mirrorTarget == target ? top : mirrorTarget.withIndirect(mirroredLight, null);
        return with(job -> job.target(top).mirrorTarget(below).indirectChange(change).mirroredIndirectChange(inMirrors));
    }

    /** Returns whether finer samples and all films stay, if indirect light and fog do. */
    public boolean keepsSamples() {
        return reweights() && films.isSame() && !films.changesEdges();
    }

    /** Returns whether nothing changes but weights, maybe between dark and lit. */
    private boolean reweights() {
        return plan != null && plan.top().onlyReweights() && plan.mirrors() != null && plan.mirrors().onlyReweights()
                && plan.shapes().isEmpty() && !plan.resampled() && plan.oldDepth() == plan.newDepth() && !togglesMirrors && canKeepFilms();
    }

    /**
     * Returns this job, whose indirect light and fog are known, with {@link #onlyReweights} and {@link #keepsFilms}.
     *
     * @param old cache of the last picture
     */
    RenderJob compare(@Nullable PixelCache old) {
        boolean only = keepsSamples() && indirectChange.isNone() && !changesBounceFog
                && !FogUpdate.showsOtherLight(requireNonNull(old).shown().fog(), fog);
        return with(job -> job.onlyReweights(only).keepsFilms(doFilmsPay(old)));
    }

    /** Returns whether films are worth their memory: composing them takes much longer than adding them, or weights are being edited. */
    private boolean doFilmsPay(@Nullable PixelCache old) {
        long bytes = FilmMemory.centerBytes(scene());
        return canKeepFilms() && FilmMemory.pays(scene()) && bytes <= options.memory() / 4
                || options.fades() && reweights() && old != null && (old.keepsFilms() || old.bytes() + bytes <= options.memory());
    }

    private static @Nullable IndirectLight light(@Nullable IndirectCache indirect) {
        return indirect == null ? null : indirect.light();
    }

    /** Returns whether mirrors show an earlier scene. */
    boolean areMirrorsOutdated() {
        return mirrorTarget != target;
    }

    /** Returns whether tiles store what bounced rays show, all films added: mirrors may show it later, or its levels are not stored. */
    boolean storesImages() {
        return !options.keepsReflectionsCurrent() || !storesMirrorRows();
    }

    /** Returns the film whose weight alone changes, if keeping the sums beside it is faster than adding all films; otherwise −1. */
    int faded() {
        boolean pays = options.fades() && onlyReweights && films.reweighted().cardinality() == 1
                && FilmMemory.canKeepBranches(scene(), target.parts().count(), options.memory());
        return pays ? films.reweighted().nextSetBit(0) : -1;
    }

    /** Returns whether stored films can add up to the picture. */
    private boolean canKeepFilms() {
        return options.method().isExact() && !storesImages() && !areMirrorsOutdated();
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
