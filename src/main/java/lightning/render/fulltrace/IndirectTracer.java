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
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.IndirectSolver;
import lightning.render.shading.RayCounts;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.SurfelShader;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.ScratchColumns;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.scene.AntialiasMode;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Computes the indirect light of a scene for a full trace: stores nothing but the light of gather points. */
final class IndirectTracer {
    private final Geometry geometry;
    private final Scene scene;
    private final WeightedLight[] lights;
    private final EngineChoice engines;
    private final WorkerPool workers;
    private final Progress progress;
    private long gatherRays;
    private long shadowRays;

    IndirectTracer(Geometry geometry, Scene scene, WeightedLight[] lights, EngineChoice engines, WorkerPool workers, Progress progress) {
        this.geometry = geometry;
        this.scene = scene;
        this.lights = lights;
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

        /**
         * Computes the light of a block; {@code edges} is null without edge detection.
         *
         * @param seen receives the light that reflections show; empty if there are none, as {@code seenEdges}
         */
        void shade(HitRows rows, int[] numbers, WeightedLight[] edgeLights, float[][] direct, float @Nullable [][] edges, float[][] albedo,
                float[][] glow, float[][] seen, float[][] seenEdges) {
            columns.reset();
            LightLayer[] layers = new LightLayer[lights.length];
            for (int l = 0; l < lights.length && !progress.isCanceled(); l++) {
                layers[l] = lights[l].isDark() ? null : kernel.recompute(rows, lights[l].source(), columns);
            }
            if (!progress.isCanceled()) {
                shader.writeDirectLight(rows, lights, layers, numbers, direct);
                if (edges != null) {
                    shader.writeDirectLight(rows, edgeLights, layers, numbers, edges);
                }
                shader.writeReflection(rows, numbers, albedo, glow, seen, (float) scene.world().ambience());
                shader.addShownLight(rows, edgeLights, layers, numbers, seen, seenEdges);
                shader.addShownLight(rows, lights, layers, numbers, seen, seen);
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
        Optional<GatherSettings> settings = GatherSettings.of(scene);
        if (settings.isEmpty()) {
            return null;
        }
        GatherStructure structure = new GatherBuilder(geometry, scene, settings.get(), workers,
                worker -> engines.forTile(0).tracer(geometry), HeapBudget.availableBytes(), progress).build();
        WeightedLight[] edgeLights = WeightedLight.forEdges(lights);
        float[][] direct = new float[3][structure.surfelCount()];
        float[][] edges =
                scene.picture().sampling().antialias() == AntialiasMode.EDGES ? new float[3][structure.surfelCount()] : null;
        float[][] albedo = new float[3][structure.surfelCount()];
        float[][] glow = new float[3][structure.surfelCount()];
        HitRows[] rows = structure.surfels();
        List<EngineWorkers<SurfelTracer>> threads = EngineWorkers.perThread(workers.count(), engines,
                engine -> new SurfelTracer(engine, settings.get().reflections()));
        float[][] seen = new float[3][structure.reflections() == null ? 0 : structure.surfelCount()];
        float[][] seenEdges = new float[3][edges == null ? 0 : seen[0].length];
        workers.run(structure.bounces() > 0 ? rows.length : 0,
                (worker, block) -> threads.get(worker).forTile(block).shade(rows[block], structure.numbers(block),
                        edgeLights, direct, edges, albedo, glow, seen, seenEdges),
                progress.cancellationOnly());
        gatherRays = structure.rays();
        shadowRays = threads.stream().flatMap(thread -> thread.workers().stream()).mapToLong(tracer -> tracer.kernel.shadowRays()).sum();
        IndirectSolver solver = new IndirectSolver(structure, workers, progress);
        float[][] objects = structure.glow().shapes().glow(geometry.materials());
        BackgroundLight background = BackgroundLight.of(scene);
        return new IndirectLight(structure, solver.solve(direct, albedo, glow, objects, seen, background),
                edges == null ? null : solver.solve(edges, albedo, glow, objects, seenEdges, background.forEdges()));
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        return new RayCounts(0, 0, gatherRays, shadowRays);
    }
}
