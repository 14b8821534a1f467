package lightning.render.gather;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;

/** Builds the filter of reflection points: means over neighbors that reflect nearly the same. */
final class ReflectionFilter {
    private static final int BATCH = 256;
    /** Reach in radii of points. */
    private static final float RADII = 2;

    private ReflectionFilter() {}

    static PointFilter build(ReflectionGroup[] groups, int points, WorkerPool workers, Progress progress) {
        int[][] neighbors = new int[points][];
        float[][] weights = new float[points][];
        for (ReflectionGroup group : groups) {
            build(group, neighbors, weights, workers, progress);
        }
        return PointFilter.of(neighbors, weights);
    }

    private static void build(ReflectionGroup group, int[][] neighbors, float[][] weights, WorkerPool workers, Progress progress) {
        float[] reach = new float[group.count()];
        for (int p = 0; p < reach.length; p++) {
            reach[p] = RADII * group.radius[p];
        }
        PointGroups wide = group.groups.withRadius(reach);
        int[] order = wide.order().clone();
        NearPoints[] near = new NearPoints[workers.count()];
        LinearWeights[] linear = new LinearWeights[workers.count()];
        workers.run(Math.ceilDiv(reach.length, BATCH), (worker, job) -> {
            near[worker] = near[worker] == null ? new NearPoints(group.surface, reach, wide) : near[worker];
            linear[worker] = linear[worker] == null ? new LinearWeights() : linear[worker];
            SurfaceColumns s = group.surface;
            near[worker].find(s.px, s.py, s.pz, order, job * BATCH, Math.min(reach.length, job * BATCH + BATCH),
                    (p, candidates) -> link(group, p, reach, near[worker], candidates, linear[worker], neighbors, weights));
        }, progress.cancellationOnly());
    }

    private static void link(ReflectionGroup group, int p, float[] reach, NearPoints near, int candidates, LinearWeights linear,
            int[][] neighbors, float[][] weights) {
        SurfaceColumns s = group.surface;
        int[] point = new int[candidates];
        linear.start(s.nx[p], s.ny[p], s.nz[p], reach[p]);
        for (int i = 0; i < candidates; i++) {
            int q = near.point(near.near[i]);
            float share = group.radius[q] / group.radius[p];
            float w = (float) Math.sqrt(ReflectionWeight.at(group, q, Math.min(reach[p], reach[q]), s.px[p], s.py[p], s.pz[p], s.nx[p],
                    s.ny[p], s.nz[p], group.rx[p], group.ry[p], group.rz[p])) * (share * share);
            if (w > 0) {
                point[linear.count()] = group.number[q];
                linear.add(w, s.px[q] - s.px[p], s.py[q] - s.py[p], s.pz[q] - s.pz[p]);
            }
        }
        linear.adjust();
        int number = group.number[p];
        float largest = linear.largest();
        if (!(largest > 0) || largest == Float.POSITIVE_INFINITY) {
            neighbors[number] = new int[] {number};
            weights[number] = new float[] {1};
            return;
        }
        neighbors[number] = Arrays.copyOf(point, linear.count());
        weights[number] = new float[linear.count()];
        for (int i = 0; i < linear.count(); i++) {
            weights[number][i] = linear.weight(i);
        }
    }
}
