package lightning.render.shading.fog;

import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.shading.LightSource;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.PointShadows;
import lightning.render.shading.layer.RowBits;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShapeChange;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Finds the samples of fog that a light reaches, on all threads. */
public final class FogShadows {
    /** Rays of a task: one shadow ray from each sample of a region of rays is cast together. */
    private static final int RAYS = 1024;
    private static final int SIDE = 32;

    private final FogGrid grid;
    private final WorkerPool workers;
    private final List<EngineWorkers<PointShadows>> casters;
    private final Progress progress;
    private final Region[] regions;

    /** @param view its effects decide whether shapes block light */
    public FogShadows(FogGrid grid, Geometry geometry, ViewEffects view, EngineChoice engines, WorkerPool workers, Progress progress) {
        this.grid = grid;
        this.workers = workers;
        casters = EngineWorkers.perThread(workers.count(), engines,
                engine -> new PointShadows(geometry, engine.tracer(geometry), view));
        this.progress = progress.cancellationOnly();
        regions = new Region[workers.count()];
        Arrays.setAll(regions, _ -> new Region());
    }

    /**
     * Returns the samples that see a light, one bit each: {@code int[rays]}.
     *
     * @param before samples that saw it before a change of shapes; null if all must be tested
     * @param change change of the shapes since then
     */
    public int[] visible(LightSource source, int @Nullable [] before, ShapeChange change) {
        int[] visible = before == null ? new int[grid.count()] : before.clone();
        FogSamples samples = new FogSamples(grid, source);
        int across = (grid.columns() + SIDE - 1) / SIDE;
        int down = (grid.lines() + SIDE - 1) / SIDE;
        workers.run(across * down, (worker, i) -> {
            PointShadows shadows = casters.get(worker).forTile(i);
            regions[worker].test(i % across * SIDE, i / across * SIDE, samples, shadows, before == null ? null : change, visible);
        }, progress);
        return visible;
    }

    /** Returns the number of shadow rays cast since the start. */
    public long rayCount() {
        return casters.stream().flatMap(thread -> thread.workers().stream()).mapToLong(PointShadows::rayCount).sum();
    }

    /** Scratch memory for the rays of a region. */
    private final class Region {
        /** Path of each ray toward the present light. */
        private final FogPath[] paths = new FogPath[RAYS];
        private final int[] rays = new int[RAYS];
        private final double[] dx = new double[RAYS];
        private final double[] dy = new double[RAYS];
        private final double[] dz = new double[RAYS];
        /** Rays of the present points. */
        private final int[] point = new int[RAYS];
        private final byte[] state = new byte[RAYS];
        private final int[] chosen = RowBits.allocate();
        private final int[] blocked = RowBits.allocate();

        Region() {
            Arrays.setAll(paths, _ -> new FogPath());
        }

        void test(int column, int line, FogSamples samples, PointShadows shadows, @Nullable ShapeChange change, int[] visible) {
            int count = 0;
            for (int y = line; y < Math.min(grid.lines(), line + SIDE); y++) {
                for (int x = column; x < Math.min(grid.columns(), column + SIDE); x++) {
                    rays[count] = y * grid.columns() + x;
                    grid.writeDirection(rays[count], dx, dy, dz, count);
                    samples.aim(paths[count], dx[count], dy[count], dz[count]);
                    count++;
                }
            }
            for (int sample = 0; sample < FogGrid.SAMPLES && !progress.isCanceled(); sample++) {
                if (samples.isPoint()) {
                    test(count, sample, -1, samples, shadows, change, visible);
                } else {
                    for (int phase = 0; phase < FogGrid.PHASES; phase++) {
                        test(count, sample, phase, samples, shadows, change, visible);
                    }
                }
            }
        }

        /** @param only phase of the rays to test; negative for all */
        private void test(int count, int sample, int only, FogSamples samples, PointShadows shadows, @Nullable ShapeChange change,
                int[] visible) {
            HitRows points = shadows.points();
            points.clear();
            for (int i = 0; i < count; i++) {
                int phase = grid.phase(rays[i]);
                if (only < 0 || phase == only) {
                    double t = paths[i].distance(grid.place(sample, phase));
                    point[points.count] = rays[i];
                    points.px[points.count] = (float) (grid.eye().x() + t * dx[i]);
                    points.py[points.count] = (float) (grid.eye().y() + t * dy[i]);
                    points.pz[points.count++] = (float) (grid.eye().z() + t * dz[i]);
                }
            }
            if (points.count == 0) {
                return;
            }
            LightSource source = samples.source(sample, Math.max(only, 0));
            Arrays.fill(chosen, 0);
            if (change == null) {
                RowBits.add(chosen, 0, points.count);
            } else {
                for (int i = 0; i < points.count; i++) {
                    state[i] = (byte) ((visible[point[i]] >>> sample & 1) != 0 ? LightRows.UNBLOCKED : LightRows.BLOCKED);
                }
                if (!shadows.findChanged(source, state, change, chosen)) {
                    return;
                }
            }
            shadows.cast(source, chosen, blocked);
            for (int i = 0; i < points.count; i++) {
                if (RowBits.contains(chosen, i)) {
                    visible[point[i]] = visible[point[i]] & ~(1 << sample) | (RowBits.contains(blocked, i) ? 0 : 1 << sample);
                }
            }
        }
    }
}
