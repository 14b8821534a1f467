package lightning.render.shading.fog;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRays;
import lightning.render.shading.LightSource;

/**
 * Computes what fog scatters at the samples along rays, on all threads. Casts no ray.
 *
 * @param anisotropy mean cosine of scattering
 * @param depths     distance of the first surface along each ray
 */
public record FogSolver(FogRays rays, FogMedium medium, double anisotropy, float[] depths, WorkerPool workers, Progress progress) {
    /** Rays of a task. */
    private static final int RAYS = 512;

    public FogSolver {
        progress = progress.cancellationOnly();
    }

    /** @param visible samples of each ray that see the light */
    public FogLight solve(LightSource source, int[] visible) {
        float[] parts = new float[rays.count() * FogGrid.SAMPLES];
        FogScattering[] scattering = new FogScattering[workers.count()];
        for (int w = 0; w < scattering.length; w++) {
            scattering[w] = new FogScattering(rays, medium, anisotropy, source);
        }
        int tasks = (rays.count() + RAYS - 1) / RAYS;
        workers.run(tasks, (worker, i) -> {
            for (int ray = i * RAYS; ray < Math.min(rays.count(), (i + 1) * RAYS); ray++) {
                scattering[worker].write(ray, visible[ray], depths[ray], parts, ray * FogGrid.SAMPLES);
            }
        }, progress);
        return new FogLight(source.light(), medium, anisotropy, depths, visible, parts);
    }
}
