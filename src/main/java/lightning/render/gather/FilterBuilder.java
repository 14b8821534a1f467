package lightning.render.gather;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;

/** Builds the {@link PointFilter} of gather points. */
final class FilterBuilder {
    private static final int BATCH = 128;
    /** Points whose neighbors are selected together. */
    private static final int CHUNK = 8;
    /** Reach of the filter in cells of gather points. */
    private static final float CELLS = 6;
    /** Reach of the filter relative to the harmonic mean distance: contacts stay sharp. */
    private static final float SHARE = 0.4f;

    private final SurfaceColumns points;
    private final float[] radius;
    private final float[] reach;
    private final PointGroups groups;

    /**
     * @param radius of each point
     * @param side   of the largest cell at each point
     */
    FilterBuilder(SurfaceColumns points, float[] radius, float[] harmonic, float[] side) {
        this.points = points;
        this.radius = radius;
        reach = new float[points.count];
        for (int p = 0; p < points.count; p++) {
            reach[p] = Math.max(radius[p], Math.min(CELLS * side[p], SHARE * harmonic[p]));
        }
        groups = new PointGroups(points, reach);
    }

    PointFilter build(WorkerPool workers, Progress progress) {
        int jobs = Math.ceilDiv(points.count, BATCH);
        int[][] neighbors = new int[points.count][];
        float[][] weights = new float[points.count][];
        NearPoints[] near = new NearPoints[workers.count()];
        workers.run(jobs, (worker, job) -> {
            near[worker] = near[worker] == null ? new NearPoints(points, reach, groups) : near[worker];
            link(near[worker], job * BATCH, Math.min(points.count, job * BATCH + BATCH), neighbors, weights);
        }, progress.cancellationOnly());
        int[] start = new int[points.count + 1];
        for (int p = 0; p < points.count; p++) {
            start[p + 1] = Math.addExact(start[p], neighbors[p].length);
        }
        int[] point = new int[start[points.count]];
        float[] weight = new float[start[points.count]];
        for (int p = 0; p < points.count; p++) {
            System.arraycopy(neighbors[p], 0, point, start[p], neighbors[p].length);
            System.arraycopy(weights[p], 0, weight, start[p], neighbors[p].length);
        }
        return new PointFilter(start, point, weight);
    }

    private void link(NearPoints near, int from, int to, int[][] neighbors, float[][] weights) {
        near.collect(points.px, points.py, points.pz, from, to);
        for (int first = from; first < to; first += CHUNK) {
            int end = Math.min(to, first + CHUNK);
            near.select(points.px, points.py, points.pz, first, end);
            for (int p = first; p < end; p++) {
                link(p, near, neighbors, weights);
            }
        }
    }

    private void link(int p, NearPoints near, int[][] neighbors, float[][] weights) {
        int candidates = near.findNear(points.px[p], points.py[p], points.pz[p], reach[p]);
        int[] point = new int[candidates];
        float[] weight = new float[candidates];
        int count = 0;
        float sum = 0;
        for (int i = 0; i < candidates; i++) {
            int column = near.near[i];
            float w = weight(p, near.columns, column, near.point(column));
            if (w > 0) {
                point[count] = near.point(column);
                weight[count++] = w;
                sum += w;
            }
        }
        if (!(sum > 0) || sum == Float.POSITIVE_INFINITY) {
            // The squares left the range of floats.
            neighbors[p] = new int[] {p};
            weights[p] = new float[] {1};
            return;
        }
        for (int i = 0; i < count; i++) {
            weight[i] /= sum;
        }
        neighbors[p] = Arrays.copyOf(point, count);
        weights[p] = Arrays.copyOf(weight, count);
    }

    /** Returns the weight of a neighbor: a point near a contact takes nothing from afar. It stands for its share of the surface. */
    private float weight(int p, SurfaceColumns columns, int column, int neighbor) {
        float share = radius[neighbor] / radius[p];
        return PointWeight.at(columns, column, Math.min(reach[p], reach[neighbor]), points.px[p], points.py[p], points.pz[p], points.nx[p],
                points.ny[p], points.nz[p]) * (share * share);
    }
}
