package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.EngineWorkers;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.PointChanges;
import lightning.render.gather.build.GatherBuilder;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RayCounts;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.scene.GatherSettings;
import org.jspecify.annotations.Nullable;

/**
 * Computes the indirect light of a job's target scene on all threads. Keeps the paths of the last picture if no ray can differ, and
 * updates the layers of surfels like those of any level.
 */
final class IndirectBuilder {
    /** Usual share of paths in the time of a job that traces them. The weights of rows take most of the rest. */
    private static final double PATHS_SHARE = 0.7;

    private final RenderJob job;
    private final WorkerPool workers;
    private final @Nullable PixelCache oldCache;
    private List<EngineWorkers<LevelWorker>> surfelWorkers = List.of();
    private long gatherRays;
    private @Nullable PointChanges pointChanges;

    /** @param old cache of the last picture */
    IndirectBuilder(RenderJob job, WorkerPool workers, @Nullable PixelCache old) {
        this.job = job;
        this.workers = workers;
        this.oldCache = old;
    }

    /**
     * Returns the indirect light; null if the scene has none.
     *
     * @throws java.util.concurrent.CancellationException if the job's progress requested cancellation
     */
    @Nullable
    IndirectCache build() {
        PathUpdate paths = job.plan() == null ? PathUpdate.BUILD : job.plan().paths();
        IndirectCache before = paths == PathUpdate.KEEP || paths == PathUpdate.REPEAT ? requireNonNull(oldCache).indirect() : null;
        // Known paths may serve more than the scene needs.
        Optional<GatherSettings> settings =
                before != null ? Optional.of(before.settings()) : paths == PathUpdate.NONE ? Optional.empty()
                        : GatherSettings.of(job.scene());
        if (settings.isEmpty()) {
            return null;
        }
        boolean shines = settings.get().reflections();
        surfelWorkers = EngineWorkers.perThread(workers.count(), job.options().engines(),
                engine -> LevelWorker.forSurfels(job, engine, shines));
        GatherStructure structure;
        TileLevel[] surfels;
        boolean keepsPaths = paths == PathUpdate.KEEP;
        if (keepsPaths) {
            assert before != null;
            structure = before.structure();
            surfels = before.structure().bounces() > 0 ? updateSurfels(before.surfels()) : before.surfels();
        } else {
            GatherBuilder builder = prepare(settings.get(), before);
            structure = builder.build();
            gatherRays += structure.rays();
            job.progress().raysCast(structure.rays());
            surfels = lightSurfels(structure);
            if (before != null && structure.kept() != null) {
                SurfelUpdate update = new SurfelUpdate(before, structure);
                workers.run(before.surfels().length,
                        (worker, block) -> update.keep(block, surfelWorker(worker, block), job),
                        job.progress().cancellationOnly());
                update.add(surfels);
                structure = update.structure();
                pointChanges = builder.changes(structure);
                surfels = update.surfels();
            }
        }
        return new IndirectCache(settings.get(), surfels, light(structure, surfels, keepsPaths ? before : null));
    }

    /** @param before indirect light of the last picture along the same paths */
    private IndirectLight light(GatherStructure structure, TileLevel[] surfels, @Nullable IndirectCache before) {
        BackgroundLight background = BackgroundLight.of(job.scene());
        BackgroundLight known = before == null ? background : BackgroundLight.of(requireNonNull(oldCache).scene());
        boolean showsAmbience = before != null && before.structure().reflections() != null
                && job.scene().world().ambience() != requireNonNull(oldCache).scene().world().ambience();
        boolean keepsColors =
                before != null && !showsAmbience && background.equals(known)
                        && isUnchanged(before, surfels, requireNonNull(job.topPlan())::canChangeColors);
        boolean keepsEdges = !job.detectsEdges()
                || before != null && !showsAmbience && background.forEdges().equals(known.forEdges()) && before.light().edgeLight() != null
                        && isUnchanged(before, surfels, requireNonNull(job.topPlan())::canChangeEdges);
        float[][] edgesBefore = before == null || !job.detectsEdges() ? null : before.light().edgeLight();
        if (before != null && keepsColors && keepsEdges) {
            return edgesBefore == before.light().edgeLight() ? before.light()
                    : new IndirectLight(structure, before.light().light(), edgesBefore);
        }
        SurfelSolver solver = new SurfelSolver(structure, surfels, job.target().geometry().materials(), job.scene().world().ambience(),
                job.options().engines(), workers, job.progress());
        return new IndirectLight(structure,
                before != null && keepsColors ? before.light().light() : solver.solve(job.target().lights(), background),
                keepsEdges ? edgesBefore : edgeSolver(solver, structure, surfels).solve(job.target().edgeLights(), background.forEdges()));
    }

    /** Returns whether no light or material changes what any surfel sends. */
    private boolean isUnchanged(IndirectCache known, TileLevel[] after, BiPredicate<TileLevel, LightLayer[]> canChange) {
        if (known.structure().bounces() == 0) {
            return true;
        }
        TileLevel[] before = known.surfels();
        return requireNonNull(job.topPlan()).materials().isEmpty()
                && IntStream.range(0, after.length).noneMatch(block -> canChange.test(before[block], after[block].layers()));
    }

    /** Returns the change of the gather points; null if all may have changed, or none did. */
    @Nullable
    PointChanges pointChanges() {
        return pointChanges;
    }

    /** Returns the solver for lights with rounded weights. Layers of some methods contain the exact weights, so they are replaced by terms. */
    private SurfelSolver edgeSolver(SurfelSolver solver, GatherStructure structure, TileLevel[] surfels) {
        if (job.options().method().isExact() || structure.bounces() == 0) {
            return solver;
        }
        TileLevel[] terms = new TileLevel[surfels.length];
        workers.run(surfels.length, (worker, block) -> terms[block] = surfelWorker(worker, block).withTerms(surfels[block]),
                job.progress().cancellationOnly());
        return new SurfelSolver(structure, terms, job.target().geometry().materials(), job.scene().world().ambience(),
                job.options().engines(),
                workers, job.progress());
    }

    private LevelWorker surfelWorker(int worker, int block) {
        return surfelWorkers.get(worker).forTile(block);
    }

    /** @param before paths of which those that cannot differ are kept */
    private GatherBuilder prepare(GatherSettings settings, @Nullable IndirectCache before) {
        GatherBuilder builder = new GatherBuilder(job.target().geometry(), job.scene(), settings, workers,
                _ -> job.options().engines().forTile(0).tracer(job.target().geometry()),
                Math.min(job.options().memory(), HeapBudget.availableBytes()), new ProgressPart(job.progress(), 0, PATHS_SHARE));
        if (before != null && SurfelUpdate.isCompact(before)) {
            HitRows[] rows = Arrays.stream(before.surfels()).map(TileLevel::rows).toArray(HitRows[]::new);
            Geometry geometry = requireNonNull(oldCache).geometry();
            builder.remember(before.structure(), rows, geometry, job.shapeChange(),
                    _ -> job.options().engines().forTile(0).tracer(geometry));
        }
        return builder;
    }

    private TileLevel[] lightSurfels(GatherStructure structure) {
        var rows = structure.surfels();
        TileLevel[] surfels = new TileLevel[rows.length];
        if (structure.bounces() == 0) {
            Arrays.setAll(surfels, block -> new TileLevel(rows[block], new LightLayer[0]));
            return surfels;
        }
        workers.run(surfels.length, (worker, block) -> surfels[block] = surfelWorker(worker, block).lightLevel(rows[block]),
                job.progress().cancellationOnly());
        return surfels;
    }

    private TileLevel[] updateSurfels(TileLevel[] before) {
        TileLevel[] surfels = new TileLevel[before.length];
        workers.run(surfels.length,
                (worker, block) -> surfels[block] = surfelWorker(worker, block).update(before[block], requireNonNull(job.topPlan())),
                job.progress().cancellationOnly());
        return surfels;
    }

    /** Returns the progress of the job's tiles, which follow. */
    Progress tileProgress() {
        return gatherRays == 0 ? job.progress() : new ProgressPart(job.progress(), PATHS_SHARE, 1);
    }

    /** Returns the work since the start. */
    WorkCounts work() {
        return surfelWorkers.stream().flatMap(thread -> thread.workers().stream())
                .map(worker -> new WorkCounts(worker.rowsTouched(), 0, worker.bytesMoved(),
                        new RayCounts(0, 0, 0, worker.shadowRays())))
                .reduce(new WorkCounts(0, 0, 0, new RayCounts(0, 0, gatherRays, 0)), WorkCounts::plus);
    }
}
