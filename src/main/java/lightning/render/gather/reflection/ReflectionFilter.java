package lightning.render.gather.reflection;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.NeighborFilter;
import lightning.render.gather.point.PointFilter;

/** Builds the filter of reflection points: means over neighbors that reflect nearly the same. */
public final class ReflectionFilter {
    /** Reach in radii of points. */
    private static final float RADII = 2;

    private ReflectionFilter() {}

    public static PointFilter build(ReflectionGroup[] groups, int points, WorkerPool workers, Progress progress) {
        int[][] neighbors = new int[points][];
        float[][] weights = new float[points][];
        for (ReflectionGroup group : groups) {
            float[] reach = new float[group.count()];
            for (int p = 0; p < reach.length; p++) {
                reach[p] = RADII * group.radius[p];
            }
            NeighborFilter.add(group.surface, reach, group.groups, (p, q) -> weight(group, p, q, Math.min(reach[p], reach[q])),
                    group.number, neighbors, weights, workers, progress);
        }
        return PointFilter.of(neighbors, weights);
    }

    /** Returns the weight of a neighbor, which stands for its share of the surface. */
    private static float weight(ReflectionGroup group, int p, int q, float reach) {
        SurfaceColumns s = group.surface;
        float share = group.radius[q] / group.radius[p];
        return (float) Math.sqrt(ReflectionWeight.at(group, q, reach, s.px[p], s.py[p], s.pz[p], s.nx[p], s.ny[p], s.nz[p], group.rx[p],
                group.ry[p], group.rz[p], group.roughness[p])) * (share * share);
    }
}
