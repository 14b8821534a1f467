package lightning.render.relight.tile;

import java.util.BitSet;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.TileLevel;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.shading.FilmParts;
import lightning.render.shading.composition.SurfelLight;
import lightning.render.shading.composition.SurfelShader;
import lightning.render.trace.MaterialTable;
import org.jspecify.annotations.Nullable;

/** Computes the light at gather points from cached layers of surfels. Casts no ray. */
final class SurfelSolver {
    private final GatherStructure structure;
    private final TileLevel[] surfels;
    private final MaterialTable materials;
    private final List<EngineWorkers<SurfelShader>> shaders;
    private final FilmKernel kernel;
    private final WorkerPool workers;
    private final Progress progress;

    /** @param surfels rows of the surfels with one layer per light of the scene, in blocks */
    SurfelSolver(GatherStructure structure, TileLevel[] surfels, MaterialTable materials, EngineChoice engines, WorkerPool workers,
            Progress progress) {
        this.structure = structure;
        this.surfels = surfels;
        this.materials = materials;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
        kernel = engines.forTile(0).sums();
        shaders = EngineWorkers.perThread(workers.count(), engines, engine -> new SurfelShader(materials, engine.sums()));
    }

    /**
     * Returns the light at all points in some films, as {@link SurfelLight#solve}.
     *
     * @param films films to compute; none is dark
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    float[] @Nullable [][] solve(FilmParts parts, BitSet films) {
        SurfelLight light = new SurfelLight(structure, materials, parts, films);
        workers.run(structure.bounces() == 0 ? 0 : surfels.length,
                (worker, block) -> light.write(structure.numbers(block), surfels[block].rows(), surfels[block].layers(),
                        shaders.get(worker).forTile(block)),
                progress);
        return light.solve(kernel, workers, progress);
    }
}
