package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.MaterialUpdate;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.RayCounts;
import lightning.render.shading.fog.FogComposer;
import lightning.render.shading.fog.FogLookup;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowSplice;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import org.jspecify.annotations.Nullable;

/** Builds and updates cached tiles with one engine. Holds scratch memory: use one instance per thread. */
final class TileWorker {
    private final RenderJob job;
    private final Engine engine;
    private final Tracer tracer;
    private final LevelWorker eyeWorker;
    /** True if rows store their owner shapes. */
    private final boolean needsOwners;
    /** Created on first use. */
    private @Nullable LevelWorker mirrorWorker;
    /** Created on first use. */
    private @Nullable BounceLevels bounceLevels;
    /** Created on first use. */
    private @Nullable FogLookup fogLookup;
    private final FogComposer fogComposer = new FogComposer();
    /** Composes the colors by which edges are detected; created on first use. */
    private @Nullable TileRecomposer edgeComposer;
    /** Colors of samples whose colors are not stored; allocated on first use. */
    private float @Nullable [][] sampleColors;
    /** Colors composed last. */
    private float @Nullable [][] colors;
    /** True if the last tile or block was composed. */
    private boolean hasNewColors;
    private long eyeRays;
    private long filmBytes;

    TileWorker(RenderJob job, Engine engine) {
        this.job = job;
        this.engine = engine;
        tracer = engine.tracer(job.target().geometry());
        eyeWorker = new LevelWorker(job, job.target(), engine, tracer);
        needsOwners = job.needsOwners();
    }

    private LevelWorker mirrorWorker() {
        if (mirrorWorker == null) {
            mirrorWorker = job.mirrorTarget() == job.target() ? eyeWorker : new LevelWorker(job, job.mirrorTarget(), engine, tracer);
        }
        return mirrorWorker;
    }

    private BounceLevels bounceLevels() {
        bounceLevels = bounceLevels == null ? new BounceLevels(job, mirrorWorker()) : bounceLevels;
        return bounceLevels;
    }

    /** Returns the work since the start. */
    WorkCounts work() {
        WorkCounts work = new WorkCounts(eyeWorker.rowsTouched(), eyeWorker.rowsComposed(), eyeWorker.bytesMoved() + filmBytes,
                new RayCounts(eyeRays, bounceLevels == null ? 0 : bounceLevels.rayCount(), 0, eyeWorker.shadowRays()));
        return mirrorWorker == null || mirrorWorker == eyeWorker ? work
                : work.plus(new WorkCounts(mirrorWorker.rowsTouched(), mirrorWorker.rowsComposed(), mirrorWorker.bytesMoved(),
                        new RayCounts(0, 0, 0, mirrorWorker.shadowRays())));
    }

    double minFalloff() {
        return eyeWorker.minFalloff();
    }

    /** Traces the centers of a tile's pixels into a new cached tile; null if the work was canceled. */
    @Nullable
    CachedTile firstPass(int tile) {
        int x0 = tile % job.tilesX() * Film.TILE_SIZE;
        int y0 = tile / job.tilesX() * Film.TILE_SIZE;
        eyeRays += (long) Math.min(Film.TILE_SIZE, job.scene().picture().width() - x0)
                * Math.min(Film.TILE_SIZE, job.scene().picture().height() - y0);
        return buildTraced(SamplePositions.centers(x0, y0),
                eyeWorker.visibility().traceEyeRays(x0, y0, Film.TILE_SIZE, allocator(false)), job.detectsEdges(), false);
    }

    /**
     * Traces finer samples; null if the work was canceled.
     *
     * @param detectEdges true if their colors decide about further samples
     */
    @Nullable
    CachedTile traceSamples(SamplePositions places, boolean detectEdges) {
        eyeRays += places.count();
        return buildTraced(places, eyeWorker.visibility().traceSamples(places, allocator(true)), detectEdges, true);
    }

    /** Returns whether the last samples have other colors than before. */
    boolean hasNewColors() {
        return hasNewColors;
    }

    /** Returns the colors of the last samples if they changed: red, green and blue, valid until the next call. */
    float[][] colors() {
        return requireNonNull(colors);
    }

    private @Nullable CachedTile buildTraced(SamplePositions places, HitRows rows, boolean detectEdges, boolean fine) {
        TileLevel top = eyeWorker.withWeights(eyeWorker.lightLevel(rows));
        BounceLevels.TracedLevels below =
                top.rows().reflectiveCount == 0 ? new BounceLevels.TracedLevels(new TileLevel[] {top}, new int[0][], null, true)
                        : bounceLevels().traceAll(places, top, new int[0][]);
        if (job.progress().isCanceled()) {
            return null;
        }
        return buildTile(places, top, below, false, null, detectEdges ? edgeColors(places, top, edgeImages(places, top)) : null, fine,
                null);
    }

    private TileRecomposer edgeComposer() {
        if (edgeComposer == null) {
            edgeComposer = new TileRecomposer(job.target().scene(), job.target().geometry().materials(),
                    job.mirrorTarget().geometry().materials(), job.depth(),
                    engine, job.options().view());
            edgeComposer.setIndirect(edgeIndirect(job.target()), edgeIndirect(job.mirrorTarget()));
        }
        return edgeComposer;
    }

    private static float @Nullable [][] edgeIndirect(PreparedScene scene) {
        return scene.indirect() == null ? null : scene.indirect().edgeLight();
    }

    /** Returns the colors for edges of the rays that bounce from the first level's rows, of the levels traced or updated last. */
    private @Nullable BounceImages edgeImages(SamplePositions places, TileLevel top) {
        return top.rows().reflectiveCount == 0 ? null : edgeImages(places, bounceLevels().lastLevels());
    }

    private @Nullable BounceImages edgeImages(SamplePositions places, TileLevel[] levels) {
        return edgeComposer().composeImages(places, bounceLevels().withTerms(levels), job.mirrorTarget().edgeLights(),
                job.mirrorTarget().scene().world());
    }

    /**
     * Composes the colors by which edges are detected.
     *
     * @param images colors of the rays that bounce from the first level's rows; null if there are none
     */
    private EdgeColors edgeColors(SamplePositions places, TileLevel top, @Nullable BounceImages images) {
        float[][] film = edgeComposer().composeFilm(eyeWorker.withTerms(top), job.target().edgeLights(), job.scene(), places, images);
        // Levels that are not stored cannot be composed again.
        boolean storesImages = images != null && !job.storesMirrorRows();
        return new EdgeColors(EdgeColors.pack(film), images != null && storesImages ? images.compact(top.rows()) : null);
    }

    private TileVisibility.Allocator allocator(boolean fine) {
        return (count, texels, clear) -> new HitRows(count, texels, clear, fine, needsOwners);
    }

    /** Updates the centers of a tile's pixels as planned; null if the work was canceled. */
    @Nullable
    CachedTile relight(int tile, CachedTile old) {
        SamplePositions places = SamplePositions.centers(tile % job.tilesX() * Film.TILE_SIZE, tile / job.tilesX() * Film.TILE_SIZE);
        BitSet retraced = changedRays(places);
        if (!LevelWorker.isWorthUpdating(retraced, places.count())) {
            return firstPass(tile);
        }
        return relight(places, old, retraced, job.detectsEdges(), false);
    }

    /** Returns the sample positions whose rays may have another hit than before. */
    private BitSet changedRays(SamplePositions places) {
        return job.shapeChange().isEmpty() ? new BitSet()
                : eyeWorker.visibility().eyeRaysThroughBoxes(places, job.shapeChange().visibleChanges());
    }

    /** Returns the hits of camera rays through some sample positions. */
    private HitRows eyeHits(SamplePositions places) {
        if (places.pixels() != null) {
            eyeRays += places.count();
            return eyeWorker.visibility().traceSamples(places, allocator(true));
        }
        eyeRays += (long) Math.min(Film.TILE_SIZE, job.scene().picture().width() - places.x0())
                * Math.min(Film.TILE_SIZE, job.scene().picture().height() - places.y0());
        return eyeWorker.visibility().traceEyeRays(places.x0(), places.y0(), Film.TILE_SIZE, allocator(false));
    }

    /** Adds, remaps or removes the owner shapes of a tile's rows, depending on whether a light needs them. */
    private CachedTile updateOwners(SamplePositions places, CachedTile old) {
        boolean known = old.levels[0].rows().owner != null;
        return !needsOwners && !known || needsOwners && known && job.shapeChange().hasSameIndices() ? old
                : new CachedTile(needsOwners ? known ? reindexOwners(old) : withOwners(places, old) : withoutOwners(old), old.hitShapes,
                        old.images, old.film, old.edges, old.fog);
    }

    /** Traces rays again to find owner shapes; keeps rows and layers. */
    private TileLevel[] withOwners(SamplePositions places, CachedTile old) {
        TileLevel top = old.levels[0].withOwner(eyeHits(places).ownersFor(old.levels[0].rows()));
        return bounceLevels().retraceHits(old, top, (level, retracedRows) -> level.withOwner(retracedRows.ownersFor(level.rows())));
    }

    private TileLevel[] reindexOwners(CachedTile old) {
        return Arrays.stream(old.levels).map(level -> level.withOwner(job.shapeChange().mapIndices(requireNonNull(level.rows().owner))))
                .toArray(TileLevel[]::new);
    }

    private static TileLevel[] withoutOwners(CachedTile old) {
        return Arrays.stream(old.levels).map(level -> level.withOwner(null)).toArray(TileLevel[]::new);
    }

    /** Updates finer samples as planned; null if the work was canceled. */
    @Nullable
    CachedTile relight(SamplePositions places, CachedTile old, boolean detectEdges) {
        BitSet retraced = changedRays(places);
        return LevelWorker.isWorthUpdating(retraced, places.count()) ? relight(places, old, retraced, detectEdges, true)
                : traceSamples(places, detectEdges);
    }

    /**
     * @param retraced    sample positions whose rays are traced again
     * @param detectEdges true if edges are detected in these rows
     * @param fine        true if they are finer samples
     */
    private @Nullable CachedTile relight(SamplePositions places, CachedTile previous, BitSet retraced, boolean detectEdges, boolean fine) {
        CachedTile old = updateOwners(places, previous);
        TileLevel known = old.levels[0];
        LevelPlan plan = requireNonNull(job.topPlan());
        MaterialUpdate materials = plan.materials();
        RowSplice order = !retraced.isEmpty() || materials.mirroringChanged().intersects(known.rows())
                ? RowSplice.sort(known.rows(), retraced, job.target().geometry().materials()) : null;
        TileLevel sorted = order == null ? known : eyeWorker.reorder(order, known);
        sorted = eyeWorker.retexture(sorted, places, plan);
        TileLevel top = eyeWorker.update(sorted, plan);
        if (!retraced.isEmpty() && !job.progress().isCanceled()) {
            TileLevel added =
                    eyeWorker.lightLevel(eyeWorker.visibility().traceEyeRays(places, retraced, allocator(fine)));
            eyeRays += retraced.cardinality();
            RowSplice all = RowSplice.join(Film.TILE_PIXELS, top.rows(), added.rows(), job.target().geometry().materials());
            top = eyeWorker.join(all, top, added);
            order = requireNonNull(order).andThen(all);
        }
        if (job.progress().isCanceled()) {
            return null;
        }
        top = eyeWorker.withWeights(top);
        boolean knowsEdges = !detectEdges || old.edges != null;
        // Colors for edges that were never composed need levels, which may not be stored.
        boolean reusesBounces = job.mirrorPlan() == null && order == null
                && (knowsEdges || job.storesMirrorRows() || top.rows().reflectiveCount == 0);
        BounceLevels.TracedLevels below =
                reusesBounces ? new BounceLevels.TracedLevels(old.levels, old.hitShapes, old.images, false)
                        : updateLower(places, old, top, order);
        if (job.progress().isCanceled()) {
            return null;
        }
        boolean changesEdges = !knowsEdges || order != null || below.changesEdges() || job.topPlan().canChangeEdges(sorted, top.layers())
                || job.indirectChange().changesEdges(top.weights());
        EdgeColors edges = !detectEdges ? null
                : !changesEdges ? old.edges
                : edgeColors(places, top, reusesBounces ? knownEdgeImages(places, old) : edgeImages(places, top)).reuseIfEqual(old.edges);
        FogTile fog = order == null ? old.fog : null;
        boolean isUnchanged = order == null && below.images() == old.images && !job.topPlan().canChangeColors(sorted, top.layers())
                && !job.indirectChange().changesColors(top.weights())
                && !job.reweightsFog();
        return buildTile(places, top, below, isUnchanged, old.film, edges, fine, fog);
    }

    /** Returns the colors for edges of the rays that bounce in an old tile, whose bounce levels do not change; null if none bounces. */
    private @Nullable BounceImages knownEdgeImages(SamplePositions places, CachedTile old) {
        if (old.levels[0].rows().reflectiveCount == 0) {
            return null;
        }
        return job.storesMirrorRows() ? edgeImages(places, old.levels) : requireNonNull(old.edges).images();
    }

    /**
     * Composes the first level, unless its colors are unchanged, and builds the tile.
     *
     * @param film previous colors
     * @param fine true if the rows are finer samples, whose colors are stored only to bound errors
     * @param fogBefore fog before the same surfaces in the last picture; null for none
     */
    private CachedTile buildTile(SamplePositions places, TileLevel top, BounceLevels.TracedLevels below, boolean sameSurfaces,
            float @Nullable [][] film, @Nullable EdgeColors edges, boolean fine, @Nullable FogTile fogBefore) {
        FogTile fog = job.fog() == null ? null : fogLookup(job.fog()).tile(places, top.rows(), fogBefore);
        boolean isUnchanged = sameSurfaces && fog == fogBefore;
        TileLevel[] levels = below.levels().clone();
        levels[0] = top;
        boolean storesColors = !fine || !job.options().method().isExact();
        if (!isUnchanged) {
            colors = storesColors ? new float[3][Film.TILE_PIXELS] : sampleColors();
            eyeWorker.composer.fillBackground(top.rows(), job.scene(), places, colors);
            levels[0] = eyeWorker.compose(top, job.topPlan(), below.images(), colors);
            if (fog != null) {
                fogComposer.add(fog, job.target().lights(), job.scene().world().fog(), colors);
            }
            filmBytes += storesColors ? 12L * Film.TILE_PIXELS : 0;
        }
        hasNewColors = !isUnchanged;
        return new CachedTile(levels, below.hitShapes(), below.images(), !storesColors ? null : isUnchanged ? film : colors, edges, fog);
    }

    private FogLookup fogLookup(PictureFog fog) {
        fogLookup = fogLookup == null ? new FogLookup(fog, job.target().lights()) : fogLookup;
        return fogLookup;
    }

    private float[][] sampleColors() {
        sampleColors = sampleColors == null ? new float[3][Film.TILE_PIXELS] : sampleColors;
        return sampleColors;
    }

    /** @param order splice of the first level's rows; null if they are unchanged */
    private BounceLevels.TracedLevels updateLower(SamplePositions places, CachedTile old, TileLevel top, @Nullable RowSplice order) {
        if (top.rows().reflectiveCount == 0) {
            return new BounceLevels.TracedLevels(new TileLevel[] {top}, new int[0][], null, old.levels[0].rows().reflectiveCount > 0);
        }
        return bounceLevels().updateAll(places, old, top, order);
    }
}
