package lightning.render.fulltrace;

import java.util.List;
import java.util.Optional;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.Engine;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.build.GatherBuilder;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RayCounts;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.SurfelLight;
import lightning.render.shading.composition.SurfelShader;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.ScratchColumns;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.scene.GatherSettings;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Computes the indirect light of a scene for a full trace: stores nothing but the light of gather points. */
final class IndirectTracer {
    private final Geometry geometry;
    private final FilmParts parts;
    private final EngineChoice engines;
    private final WorkerPool workers;
    private final Progress progress;
    private RayCounts rays = RayCounts.NONE;

    IndirectTracer(Geometry geometry, FilmParts parts, EngineChoice engines, WorkerPool workers, Progress progress) {
        this.geometry = geometry;
        this.parts = parts;
        this.engines = engines;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
    }

    /** Lights and shades surfels with scratch memory. */
    private final class SurfelTracer {
        private final LightKernel kernel;
        private final SurfelShader shader;
        private final ScratchColumns columns = new ScratchColumns();

        SurfelTracer(Engine engine, boolean shines) {
            kernel = LightKernel.forSurfels(geometry, engine.tracer(geometry), engine.terms(), ViewEffects.ALL, shines);
            shader = new SurfelShader(geometry.materials(), engine.sums());
        }

        /** Computes the light of a block. */
        void shade(HitRows rows, int[] numbers, SurfelLight to) {
            columns.reset();
            WeightedLight[] lights = parts.lights();
            LightLayer[] layers = new LightLayer[lights.length];
            for (int l = 0; l < lights.length && !progress.isCanceled(); l++) {
                layers[l] = lights[l].isDark() ? null : kernel.recompute(rows, lights[l].source(), columns);
            }
            if (!progress.isCanceled()) {
                to.write(numbers, rows, layers, shader);
            }
        }
    }

    /**
     * Returns the light; null if the scene has no indirect light.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    @Nullable
    IndirectLight trace() {
        Optional<GatherSettings> settings = GatherSettings.of(parts.scene());
        if (settings.isEmpty()) {
            return null;
        }
        GatherStructure structure = new GatherBuilder(geometry, parts.scene(), settings.get(), workers,
                worker -> engines.forTile(0).tracer(geometry), HeapBudget.availableBytes(), progress).build();
        HitRows[] rows = structure.surfels();
        List<EngineWorkers<SurfelTracer>> threads = EngineWorkers.perThread(workers.count(), engines,
                engine -> new SurfelTracer(engine, settings.get().reflections()));
        SurfelLight light = new SurfelLight(structure, geometry.materials(), parts, parts.shining());
        workers.run(structure.bounces() > 0 ? rows.length : 0,
                (worker, block) -> threads.get(worker).forTile(block).shade(rows[block], structure.numbers(block), light),
                progress.cancellationOnly());
        rays = threads.stream().flatMap(thread -> thread.workers().stream()).map(tracer -> RayCounts.ofShadows(tracer.kernel.shadowRays()))
                .reduce(RayCounts.of(structure.rays()), RayCounts::plus);
        float[] @Nullable [][] solved = light.solve(engines.forTile(0).sums(), workers, progress);
        return new IndirectLight(structure, new StoredFilms(solved, parts.shining()), solved);
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        return rays;
    }
}
