package lightning.render.gather;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;

/** Builds the {@link PointFilter} of gather points. */
final class FilterBuilder {
    private static final int BATCH = 256;
    /** Reach of the filter in cells of gather points. */
    private static final float CELLS = 4;
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
        int[][] found = new int[workers.count()][];
        workers.run(jobs, (worker, job) -> {
            if (found[worker] == null) {
                found[worker] = new int[points.count];
            }
            for (int p = job * BATCH; p < Math.min(points.count, job * BATCH + BATCH); p++) {
                link(p, found[worker], neighbors, weights);
            }
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

    private void link(int p, int[] found, int[][] neighbors, float[][] weights) {
        float[] box = {points.px[p], points.py[p], points.pz[p], points.px[p], points.py[p], points.pz[p]};
        int candidates = groups.find(box, found);
        int[] point = new int[candidates];
        float[] weight = new float[candidates];
        int count = 0;
        float sum = 0;
        for (int i = 0; i < candidates; i++) {
            float w = weight(p, found[i]);
            if (w > 0) {
                point[count] = found[i];
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
    private float weight(int p, int neighbor) {
        float share = radius[neighbor] / radius[p];
        return PointWeight.at(points, neighbor, Math.min(reach[p], reach[neighbor]), points.px[p], points.py[p], points.pz[p], points.nx[p],
                points.ny[p], points.nz[p]) * (share * share);
    }
}
