package lightning.render.shading.fog;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.shading.LightSource;

/** Sums what fog scatters along all rays of a grid, on all threads. Casts no ray. */
public final class FogSolver {
    /** Rays of a task. */
    private static final int RAYS = 512;

    private final FogGrid grid;
    private final FogMedium medium;
    private final double anisotropy;
    private final WorkerPool workers;
    private final Progress progress;

    /** @param anisotropy mean cosine of scattering */
    public FogSolver(FogGrid grid, FogMedium medium, double anisotropy, WorkerPool workers, Progress progress) {
        this.grid = grid;
        this.medium = medium;
        this.anisotropy = anisotropy;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
    }

    /** @param visible samples of each ray that see the light */
    public FogLight solve(LightSource source, int[] visible) {
        float[] parts = new float[grid.count() * FogGrid.SAMPLES];
        FogScattering[] scattering = new FogScattering[workers.count()];
        for (int w = 0; w < scattering.length; w++) {
            scattering[w] = new FogScattering(grid, medium, anisotropy, source);
        }
        int tasks = (grid.count() + RAYS - 1) / RAYS;
        workers.run(tasks, (worker, i) -> {
            for (int ray = i * RAYS; ray < Math.min(grid.count(), (i + 1) * RAYS); ray++) {
                scattering[worker].write(ray, visible[ray], parts, ray * FogGrid.SAMPLES);
            }
        }, progress);
        float[] sums = new float[grid.count() * (FogGrid.SAMPLES + 1)];
        workers.run(grid.lines(), (_, line) -> sumLine(line, parts, sums), progress);
        return new FogLight(source.light(), medium, anisotropy, visible, sums);
    }

    /** Filters the parts of the inner rays of a line with weights 1, 2, 1 in both directions, and adds them up. */
    private void sumLine(int line, float[] parts, float[] sums) {
        if (line == 0 || line == grid.lines() - 1) {
            return;
        }
        for (int column = 1; column < grid.columns() - 1; column++) {
            int ray = line * grid.columns() + column;
            float sum = 0;
            int to = ray * (FogGrid.SAMPLES + 1);
            for (int k = 0; k < FogGrid.SAMPLES; k++) {
                sum += filtered(parts, ray * FogGrid.SAMPLES + k);
                sums[++to] = sum;
            }
        }
    }

    private float filtered(float[] parts, int i) {
        int line = grid.columns() * FogGrid.SAMPLES;
        return (across(parts, i - line) + 2 * across(parts, i) + across(parts, i + line)) / 16;
    }

    private static float across(float[] parts, int i) {
        return parts[i - FogGrid.SAMPLES] + 2 * parts[i] + parts[i + FogGrid.SAMPLES];
    }
}
