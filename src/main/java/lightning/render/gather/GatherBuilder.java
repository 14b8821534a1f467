package lightning.render.gather;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
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
    /** Usual shares of the time after the candidates and the rays of gather points. */
    private static final double CANDIDATES_SHARE = 0.1;
    private static final double POINTS_SHARE = 0.5;

    private final Geometry geometry;
    private final Scene scene;
    private final IndirectSettings settings;
    private final WorkerPool workers;
    private final Progress progress;
    private final Tracer[] tracers;

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
        CellKeys keys = new CellKeys(scene, settings);
        DirectionTable pointDirections = new DirectionTable(settings.raysPerSide());
        GatherCaster[] pointCasters = casters(keys, pointDirections);
        PointPlacer placer =
                new PointPlacer(workers, new ProgressPart(progress, CANDIDATES_SHARE, POINTS_SHARE), keys, pointCasters, pointDirections);
        placer.place(candidates);
        DirectionTable surfelDirections = new DirectionTable(settings.raysPerSide() / 2);
        SurfelBuilder surfels =
                new SurfelBuilder(workers, new ProgressPart(progress, POINTS_SHARE, 1), casters(keys, surfelDirections), surfelDirections);
        surfels.build(placer.points, placer.seeds(), placer.links, pointCasters, settings.bounces());
        PointFilter filter = new FilterBuilder(placer.points, placer.radius, placer.harmonic, placer.side).build(workers, progress);
        long rays = Arrays.stream(candidateTracers).mapToLong(CandidateTracer::rayCount).sum() + placer.links.surfels().length
                + surfels.links.surfels().length + surfels.count();
        return new GatherStructure(
                new GatherPoints(placer.points, placer.radius, new PointGroups(placer.points, placer.radius), filter), placer.links,
                surfels.links, surfels.blocks, surfels.blockStart, surfels.count(), settings.bounces(), rays);
    }

    private GatherCaster[] casters(CellKeys keys, DirectionTable directions) {
        GatherCaster[] casters = new GatherCaster[workers.count()];
        Arrays.setAll(casters, worker -> new GatherCaster(geometry, scene, tracers[worker], keys, directions));
        return casters;
    }

    private List<SurfaceColumns> traceCandidates(CandidateTracer[] candidateTracers) {
        PictureSettings picture = scene.picture();
        int tilesX = Film.tilesAlong(picture.width());
        @SuppressWarnings("unchecked")
        List<SurfaceColumns>[] levels = new List[tilesX * Film.tilesAlong(picture.height())];
        workers.run(levels.length,
                (worker, tile) -> levels[tile] =
                        candidateTracers[worker].trace(tile % tilesX * Film.TILE_SIZE, tile / tilesX * Film.TILE_SIZE),
                new ProgressPart(progress, 0, CANDIDATES_SHARE));
        List<SurfaceColumns> all = new ArrayList<>();
        for (List<SurfaceColumns> tile : levels) {
            all.addAll(tile);
        }
        return all;
    }
}
