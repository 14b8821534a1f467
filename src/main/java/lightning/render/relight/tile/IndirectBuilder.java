package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.EngineWorkers;
import lightning.render.gather.GatherRays;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.PointChanges;
import lightning.render.gather.build.GatherBuilder;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RayCounts;
import lightning.render.shading.StoredFilms;
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
    private GatherRays gatherRays = GatherRays.NONE;
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
            gatherRays = gatherRays.plus(structure.rays());
            job.progress().raysCast(structure.rays().total());
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
        FilmParts parts = job.target().parts();
        BitSet changed = changedFilms(before, surfels);
        StoredFilms known = before == null ? null : before.light().films();
        BitSet solved = parts.shining();
        for (int part = 0; part < parts.count() && known != null; part++) {
            int origin = job.films().origin()[part];
            solved.set(part, solved.get(part) && (changed.get(part) || !known.known().get(origin)));
        }
        if (before != null && changed.isEmpty() && solved.isEmpty() && job.films().isSame()) {
            return before.light();
        }
        float[] @Nullable [][] light = solver(structure, surfels).solve(parts, solved);
        StoredFilms films = StoredFilms.after(known, job.films().origin(), changed, solved, film -> light[film]);
        boolean isExact = job.options().method().isExact();
        return new IndirectLight(structure, films, isExact || !job.detectsEdges() ? films.colors()
                : solver(structure, terms(structure, surfels)).solve(job.target().edgeParts(), job.target().edgeParts().shining()));
    }

    private SurfelSolver solver(GatherStructure structure, TileLevel[] surfels) {
        return new SurfelSolver(structure, surfels, job.target().geometry().materials(), job.options().engines(), workers, job.progress());
    }

    /** Returns the films whose gathered light may change, dark ones too. */
    private BitSet changedFilms(@Nullable IndirectCache before, TileLevel[] surfels) {
        FilmParts parts = job.target().parts();
        BitSet changed = (BitSet) job.films().changed().clone();
        boolean changesAll = before == null || !requireNonNull(job.topPlan()).materials().isEmpty()
                || !job.scene().picture().indirect().equals(requireNonNull(oldCache).scene().picture().indirect());
        int blocks = before == null || changesAll || before.structure().bounces() == 0 ? 0 : surfels.length;
        for (int block = 0; block < blocks; block++) {
            requireNonNull(job.topPlan()).addChanged(parts, requireNonNull(before).surfels()[block], surfels[block], changed);
        }
        if (changesAll) {
            changed.set(0, parts.count());
        }
        return changed;
    }

    /** Returns the change of the gather points; null if all may have changed, or none did. */
    @Nullable
    PointChanges pointChanges() {
        return pointChanges;
    }

    /** Returns surfels whose layers contain no weights. */
    private TileLevel[] terms(GatherStructure structure, TileLevel[] surfels) {
        if (structure.bounces() == 0) {
            return surfels;
        }
        TileLevel[] terms = new TileLevel[surfels.length];
        workers.run(surfels.length, (worker, block) -> terms[block] = surfelWorker(worker, block).withTerms(surfels[block]),
                job.progress().cancellationOnly());
        return terms;
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
        return gatherRays.total() == 0 ? job.progress() : new ProgressPart(job.progress(), PATHS_SHARE, 1);
    }

    /** Returns the work since the start. */
    WorkCounts work() {
        return surfelWorkers.stream().flatMap(thread -> thread.workers().stream())
                .map(worker -> new WorkCounts(worker.rowsTouched(), 0, worker.bytesMoved(),
                        RayCounts.ofShadows(worker.shadowRays())))
                .reduce(new WorkCounts(0, 0, 0, RayCounts.of(gatherRays)), WorkCounts::plus);
    }
}
