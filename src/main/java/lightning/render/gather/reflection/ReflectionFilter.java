package lightning.render.gather.reflection;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.NeighborFilter;
import lightning.render.gather.point.PointFilter;

/**
 * Weights of the filter of reflection points: means over neighbors that reflect nearly the same.
 *
 * @param neighbors numbers of the neighbors of each point, itself included
 * @param weights   their weights, ≥ 0
 */
public record ReflectionFilter(int[][] neighbors, float[][] weights) {
    // Arrays in a record: written once by the factory, never after.

    /** Least and largest reach in radii of points. */
    private static final float MIN_RADII = 2;
    private static final float MAX_RADII = 4;
    /** Number of points of equal weight whose mean has little noise; so many are at the place of a point without neighbors. */
    public static final int ENOUGH = 8;

    /**
     * @param points number of all points
     * @param open   distance from each point within which its reflection changes little, scene units
     */
    public static ReflectionFilter of(ReflectionGroup[] groups, int points, float[] open, WorkerPool workers, Progress progress) {
        var filter = new ReflectionFilter(new int[points][], new float[points][]);
        for (ReflectionGroup group : groups) {
            float[] reach = new float[group.count()];
            for (int p = 0; p < reach.length; p++) {
                float radius = group.radius[p];
                reach[p] = Math.clamp(open[group.number[p]], MIN_RADII * radius, MAX_RADII * radius);
            }
            NeighborFilter.add(group.surface, reach, group.groups, (p, q) -> weight(group, p, q, Math.min(reach[p], reach[q])),
                    group.number, filter.neighbors, filter.weights, workers, progress);
        }
        return filter;
    }

    /** Returns the weight of a neighbor, which stands for its share of the surface. */
    private static float weight(ReflectionGroup group, int p, int q, float reach) {
        SurfaceColumns s = group.surface;
        float share = group.radius[q] / group.radius[p];
        float weight = (float) Math.sqrt(ReflectionWeight.at(group, q, reach, s.px[p], s.py[p], s.pz[p], s.nx[p], s.ny[p], s.nz[p],
                group.rx[p], group.ry[p], group.rz[p], group.roughness[p])) * (share * share);
        return weight > 0 && group.material.isAnisotropic() ? weight * group.alignment(p, q) : weight;
    }

    /**
     * Returns how many more points with other rays each point needs at its place, so that its mean has little noise: none on flat surfaces, where
     * many neighbors reflect the same, most on small round ones; and fewer where the surface reflects little.
     *
     * @param share share of light that the surface of each point reflects, 0…1
     */
    public int[] copies(float[] share) {
        int[] copies = new int[neighbors.length];
        Arrays.setAll(copies, p -> {
            double sum = 0;
            double squares = 0;
            for (float w : weights[p]) {
                sum += w;
                squares += (double) w * w;
            }
            return (int) Math.ceil(ENOUGH * share[p] * squares / (sum * sum)) - 1;
        });
        return copies;
    }

    /**
     * Returns the filter over all points, in which copies follow the points and count as their originals do.
     *
     * @param copies as {@link #copies}
     */
    public PointFilter build(int[] copies) {
        int points = neighbors.length;
        int[] first = new int[points];
        int all = points;
        for (int p = 0; p < points; p++) {
            first[p] = all;
            all += copies[p];
        }
        int[][] expanded = new int[points][];
        float[][] itsWeights = new float[points][];
        for (int p = 0; p < points; p++) {
            int count = neighbors[p].length;
            for (int q : neighbors[p]) {
                count += copies[q];
            }
            int[] list = new int[count];
            float[] listed = new float[count];
            int at = 0;
            for (int i = 0; i < neighbors[p].length; i++) {
                int q = neighbors[p][i];
                for (int k = 0; k <= copies[q]; k++) {
                    list[at] = k == 0 ? q : first[q] + k - 1;
                    listed[at++] = weights[p][i];
                }
            }
            expanded[p] = list;
            itsWeights[p] = listed;
        }
        return PointFilter.of(expanded, itsWeights, all);
    }
}
