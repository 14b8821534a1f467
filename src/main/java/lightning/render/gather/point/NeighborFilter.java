package lightning.render.gather.point;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.SurfaceColumns;

/** Builds means over neighboring points from weights that depend on the two points alone. */
public final class NeighborFilter {
    private static final int BATCH = 256;

    private NeighborFilter() {}

    /** Weight of a neighbor in the mean of a point. */
    public interface Weight {
        /** @return 0 or more */
        float of(int p, int neighbor);
    }

    /**
     * Adds the neighbors of some points.
     *
     * @param reach     distance from each point within which neighbors may count, scene units
     * @param groups    of the points
     * @param number    number of each point among all
     * @param neighbors receives the numbers of the neighbors of each point by its number, as {@code weights} receives their weights
     */
    public static void add(SurfaceColumns points, float[] reach, PointGroups groups, Weight weight, int[] number, int[][] neighbors,
            float[][] weights, WorkerPool workers, Progress progress) {
        PointGroups wide = groups.withRadius(reach);
        int[] order = wide.order().clone();
        NearPoints[] near = new NearPoints[workers.count()];
        LinearWeights[] linear = new LinearWeights[workers.count()];
        workers.run(Math.ceilDiv(number.length, BATCH), (worker, job) -> {
            near[worker] = near[worker] == null ? new NearPoints(points, reach, wide) : near[worker];
            linear[worker] = linear[worker] == null ? new LinearWeights() : linear[worker];
            near[worker].find(points.px, points.py, points.pz, order, job * BATCH, Math.min(number.length, job * BATCH + BATCH),
                    (p, candidates) -> link(points, p, reach[p], near[worker], candidates, weight, linear[worker], number, neighbors,
                            weights));
        }, progress.cancellationOnly());
    }

    private static void link(SurfaceColumns s, int p, float reach, NearPoints near, int candidates, Weight weight, LinearWeights linear,
            int[] number, int[][] neighbors, float[][] weights) {
        int[] point = new int[candidates];
        linear.start(s.nx[p], s.ny[p], s.nz[p], reach);
        for (int i = 0; i < candidates; i++) {
            int q = near.point(near.near[i]);
            float w = weight.of(p, q);
            if (w > 0) {
                point[linear.count()] = number[q];
                linear.add(w, s.px[q] - s.px[p], s.py[q] - s.py[p], s.pz[q] - s.pz[p]);
            }
        }
        linear.adjust();
        float largest = linear.largest();
        if (!(largest > 0) || largest == Float.POSITIVE_INFINITY) {
            // The squares left the range of floats.
            neighbors[number[p]] = new int[] {number[p]};
            weights[number[p]] = new float[] {1};
            return;
        }
        neighbors[number[p]] = Arrays.copyOf(point, linear.count());
        weights[number[p]] = new float[linear.count()];
        for (int i = 0; i < linear.count(); i++) {
            weights[number[p]][i] = linear.weight(i);
        }
    }
}
