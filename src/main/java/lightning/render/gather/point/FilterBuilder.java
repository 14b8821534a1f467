package lightning.render.gather.point;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.SurfaceColumns;

/** Builds the {@link PointFilter} of gather points. */
public final class FilterBuilder {
    private static final int BATCH = 256;
    /** Reach of the filter in cells of gather points. */
    private static final float CELLS = 8;
    /** Reach of the filter relative to the harmonic mean distance: contacts stay sharp. */
    private static final float SHARE = 0.25f;
    /** Least reach of the filter in radii of points: the few rays of points in corners are too noisy alone. */
    private static final float RADII = 2;
    /** Least reach among points of one plane, where noise is visible, in radii; at most {@link #CELLS}. */
    private static final float FLAT_RADII = 4;

    private final SurfaceColumns points;
    private final float[] radius;
    /** Reach among points of one plane, and among others. */
    private final float[] flatReach;
    private final float[] reach;
    private final PointGroups groups;
    private final Barriers barriers;

    /**
     * @param radius of each point
     * @param pointGroups groups of the points
     * @param barriers    of the points
     * @param side   of the largest cell at each point
     */
    public FilterBuilder(SurfaceColumns points, float[] radius, PointGroups pointGroups, Barriers barriers, float[] harmonic,
            float[] side) {
        this.points = points;
        this.radius = radius;
        this.barriers = barriers;
        reach = new float[points.count];
        flatReach = new float[points.count];
        for (int p = 0; p < points.count; p++) {
            float open = Math.min(CELLS * side[p], SHARE * harmonic[p]);
            reach[p] = Math.max(RADII * radius[p], open);
            flatReach[p] = Math.max(reach[p], Math.min(FLAT_RADII * radius[p], CELLS * side[p]));
        }
        groups = pointGroups.withRadius(flatReach);
    }

    public PointFilter build(WorkerPool workers, Progress progress) {
        int jobs = Math.ceilDiv(points.count, BATCH);
        int[] order = groups.order().clone();
        int[][] neighbors = new int[points.count][];
        float[][] weights = new float[points.count][];
        NearPoints[] near = new NearPoints[workers.count()];
        LinearWeights[] linear = new LinearWeights[workers.count()];
        workers.run(jobs, (worker, job) -> {
            near[worker] = near[worker] == null ? new NearPoints(points, flatReach, groups) : near[worker];
            linear[worker] = linear[worker] == null ? new LinearWeights() : linear[worker];
            near[worker].find(points.px, points.py, points.pz, order, job * BATCH, Math.min(points.count, job * BATCH + BATCH),
                    (p, candidates) -> link(p, near[worker], candidates, linear[worker], neighbors, weights));
        }, progress.cancellationOnly());
        return PointFilter.of(neighbors, weights);
    }

    private void link(int p, NearPoints near, int candidates, LinearWeights linear, int[][] neighbors, float[][] weights) {
        int[] point = new int[candidates];
        linear.start(points.nx[p], points.ny[p], points.nz[p], flatReach[p]);
        for (int i = 0; i < candidates; i++) {
            int column = near.near[i];
            float w = weight(p, near.columns, column, near.point(column));
            if (w > 0 && !areSeparate(p, near.point(column))) {
                point[linear.count()] = near.point(column);
                linear.add(w, near.columns.px[column] - points.px[p], near.columns.py[column] - points.py[p],
                        near.columns.pz[column] - points.pz[p]);
            }
        }
        linear.adjust();
        float largest = linear.largest();
        if (!(largest > 0) || largest == Float.POSITIVE_INFINITY) {
            // The squares left the range of floats.
            neighbors[p] = new int[] {p};
            weights[p] = new float[] {1};
            return;
        }
        neighbors[p] = Arrays.copyOf(point, linear.count());
        weights[p] = new float[linear.count()];
        for (int i = 0; i < linear.count(); i++) {
            weights[p][i] = linear.weight(i);
        }
    }

    private boolean areSeparate(int p, int q) {
        return barriers.separate(points, p, points.px[q], points.py[q], points.pz[q])
                || barriers.separate(points, q, points.px[p], points.py[p], points.pz[p]);
    }

    /** Returns the weight of a neighbor: a point near a contact takes nothing from afar. It stands for its share of the surface. */
    private float weight(int p, SurfaceColumns columns, int column, int neighbor) {
        float share = radius[neighbor] / radius[p];
        float[] reaches = PointWeight.areOnOnePlane(points, p, neighbor, radius[p]) ? flatReach : reach;
        return PointWeight.flat(columns, column, Math.min(reaches[p], reaches[neighbor]), points.px[p], points.py[p], points.pz[p],
                points.nx[p], points.ny[p], points.nz[p]) * (share * share);
    }
}
