package lightning.render.relight.tile;

import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.gather.GatherStructure;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.IndirectSolver;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.SurfelShader;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.MaterialTable;

/** Computes the light at gather points from cached layers of surfels, for any weights of the lights. Casts no ray. */
public final class SurfelSolver {
    private final GatherStructure structure;
    private final TileLevel[] surfels;
    private final List<EngineWorkers<SurfelShader>> shaders;
    private final WorkerPool workers;
    private final Progress progress;
    private final float[][] albedo;
    private final float[][] glow;
    /** Light that reflections show of surfels without lights; empty if there are none. */
    private final float[][] seen;
    /** Light of each small glowing object. */
    private final float[][] objects;

    /**
     * @param indirect  indirect light of a scene
     * @param materials materials of that scene
     * @param ambience  ambient light of that scene
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public SurfelSolver(IndirectCache indirect, MaterialTable materials, double ambience, EngineChoice engines, WorkerPool workers,
            Progress progress) {
        this(indirect.structure(), indirect.surfels(), materials, ambience, engines, workers, progress);
    }

    /** @param surfels rows of the surfels with one layer per light of the scene, in blocks */
    SurfelSolver(GatherStructure structure, TileLevel[] surfels, MaterialTable materials, double ambience, EngineChoice engines,
            WorkerPool workers, Progress progress) {
        this.structure = structure;
        this.surfels = surfels;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
        shaders = EngineWorkers.perThread(workers.count(), engines, engine -> new SurfelShader(materials, engine.sums()));
        albedo = new float[3][structure.surfelCount()];
        glow = new float[3][structure.surfelCount()];
        seen = new float[3][structure.reflections() == null ? 0 : structure.surfelCount()];
        objects = structure.glow().shapes().glow(materials);
        workers.run(blocks(), (worker, block) -> shaders.get(worker).forTile(block).writeReflection(surfels[block].rows(),
                structure.numbers(block), albedo, glow, seen, (float) ambience), this.progress);
    }

    /**
     * Returns the light at all points, as {@link IndirectSolver#solve}.
     *
     * @param lights lights in the order of the surfels' layers
     * @param background light of rays that leave the scene
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public float[][] solve(WeightedLight[] lights, BackgroundLight background) {
        return solve(lights, background, glow, objects, seen);
    }

    /** Returns the light at all gather points that comes from lights alone; parameters as above. */
    public float[][] solveWithoutGlow(WeightedLight[] lights, BackgroundLight background) {
        return solve(lights, background, new float[3][structure.surfelCount()], new float[3][objects[0].length],
                new float[3][seen[0].length]);
    }

    private float[][] solve(WeightedLight[] lights, BackgroundLight background, float[][] emitted, float[][] emittedByObjects,
            float[][] shown) {
        float[][] direct = new float[3][structure.surfelCount()];
        float[][] lit = new float[3][shown[0].length];
        workers.run(blocks(), (worker, block) -> {
            SurfelShader shader = shaders.get(worker).forTile(block);
            LightLayer[] layers = surfels[block].layers();
            shader.writeDirectLight(surfels[block].rows(), lights, layers, structure.numbers(block), direct);
            shader.addShownLight(surfels[block].rows(), lights, layers, structure.numbers(block), shown, lit);
        }, progress);
        return new IndirectSolver(structure, workers, progress).solve(direct, albedo, emitted, emittedByObjects, lit, background);
    }

    /** Returns the number of blocks with lit surfels. */
    private int blocks() {
        return structure.bounces() == 0 ? 0 : surfels.length;
    }
}
