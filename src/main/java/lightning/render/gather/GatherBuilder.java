package lightning.render.gather;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.Tracer;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/** Builds the {@link GatherStructure} of a scene on all threads. The result does not depend on their number or order. */
public final class GatherBuilder {
    /** Candidates along a side of the largest cell, seen straight on. */
    private static final int CANDIDATES_PER_CELL = 4;
    /** Maximum number of gather points at a candidate: one in each size of cells. */
    public static final int MAX_POINTS_PER_CANDIDATE = CellKeys.LEVELS;

    private final Geometry geometry;
    private final Scene scene;
    private final IndirectSettings settings;
    private final WorkerPool workers;
    private final Progress progress;
    private final Tracer[] tracers;
    private final CellKeys keys;
    /** Paths before an edit, or null. */
    private GatherStructure before;
    private PathMemo memo;
    private IntFunction<Tracer> memoTracers;

    /** @param tracers one for each thread */
    public GatherBuilder(Geometry geometry, Scene scene, IndirectSettings settings, WorkerPool workers, IntFunction<Tracer> tracers,
            Progress progress) {
        this.geometry = geometry;
        this.scene = scene;
        this.settings = settings;
        this.workers = workers;
        this.progress = progress;
        this.tracers = new Tracer[workers.count()];
        Arrays.setAll(this.tracers, tracers);
        keys = new CellKeys(scene, settings);
    }

    /**
     * Uses the paths before an edit, if few enough objects changed. The structure then contains no rows of surfels that stay.
     *
     * @param old      paths of a picture with the same camera, size and settings
     * @param rows     rows of its surfels
     * @param previous geometry before the edit
     * @param shapes   edit of the shapes
     * @param itsTracers one for each thread, of that geometry
     */
    public void remember(GatherStructure old, HitRows[] rows, Geometry previous, ShapeChange shapes,
            IntFunction<Tracer> itsTracers) {
        before = old;
        memo = PathMemo.of(old, rows, previous, shapes, geometry, keys);
        memoTracers = itsTracers;
    }

    /** Returns the distance of the pixels through which candidates for gather points are traced. */
    public static int candidateStep(IndirectSettings settings) {
        return Math.max(1, settings.spacing() / CANDIDATES_PER_CELL);
    }

    /**
     * Builds it.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public GatherStructure build() {
        CandidateTracer[] candidateTracers = new CandidateTracer[workers.count()];
        Arrays.setAll(candidateTracers, worker -> new CandidateTracer(geometry, scene, tracers[worker], candidateStep(settings)));
        List<SurfaceColumns> candidates = traceCandidates(candidateTracers);
        PathCaster pointCaster = caster(new DirectionTable(settings.raysPerSide()), true);
        PointPlacer placer = new PointPlacer(workers, progress, keys, pointCaster);
        placer.place(candidates);
        PathCaster surfelCaster = caster(new DirectionTable(settings.raysPerSide() / 2), false);
        SurfelBuilder surfels = new SurfelBuilder(workers, progress, keys, surfelCaster, memo);
        surfels.build(placer.sources, placer.links, pointCaster, settings.bounces());
        PointFilter filter = new FilterBuilder(placer.points, placer.radius, placer.harmonic, placer.side).build(workers, progress);
        long rays = Arrays.stream(candidateTracers).mapToLong(CandidateTracer::rayCount).sum() + pointCaster.rayCount()
                + surfelCaster.rayCount() + Arrays.stream(surfels.blocks).mapToLong(block -> block.count).sum();
        return new GatherStructure(
                new GatherPoints(placer.sources, placer.inverseLengths, placer.radius, new PointGroups(placer.points, placer.radius),
                        filter),
                placer.links, surfels.links, new SurfelRows(surfels.blocks, surfels.numbers, surfels.near, surfels.count()), surfels.kept,
                settings.bounces(), rays);
    }

    /**
     * Returns the difference between the gather points of the paths before an edit and those after it; null if they are not used.
     *
     * @param after paths after the edit
     */
    public PointChanges changes(GatherStructure after) {
        return memo == null ? null : PointChanges.between(before, after, memo.points());
    }

    private PathCaster caster(DirectionTable directions, boolean ofPoints) {
        return new PathCaster(geometry, scene, workers, progress, tracers, memo, memoTracers, keys, directions, ofPoints);
    }

    private List<SurfaceColumns> traceCandidates(CandidateTracer[] candidateTracers) {
        PictureSettings picture = scene.picture();
        int tilesX = Film.tilesAlong(picture.width());
        @SuppressWarnings("unchecked")
        List<SurfaceColumns>[] levels = new List[tilesX * Film.tilesAlong(picture.height())];
        workers.run(levels.length,
                (worker, tile) -> levels[tile] =
                        candidateTracers[worker].trace(tile % tilesX * Film.TILE_SIZE, tile / tilesX * Film.TILE_SIZE),
                progress.cancellationOnly());
        List<SurfaceColumns> all = new ArrayList<>();
        for (List<SurfaceColumns> tile : levels) {
            all.addAll(tile);
        }
        return all;
    }
}
