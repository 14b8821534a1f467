package lightning.render.gather.build;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.NeighborFilter;
import lightning.render.gather.point.PointFilter;
import lightning.render.gather.point.PointGroups;
import lightning.render.gather.point.PointWeight;

/**
 * Builds means over neighboring surfels: reflections show single surfels, whose few rays are noisy. Only the light that they gather is
 * filtered, not what lights or textures give them.
 */
final class SurfelFilter {
    /** Reach in sides of cells. */
    private static final float SIDES = 3;

    private SurfelFilter() {}

    /** @param count number of surfels that cast rays; they come first */
    static PointFilter build(SurfaceColumns surfels, int count, CellKeys keys, WorkerPool workers, Progress progress) {
        SurfaceColumns points = new SurfaceColumns(count);
        float[] reach = new float[count];
        int[] number = new int[count];
        for (int s = 0; s < count; s++) {
            points.add(surfels, s);
            reach[s] = SIDES * (float) keys.surfelSide(surfels.px[s], surfels.py[s], surfels.pz[s], 0);
            number[s] = s;
        }
        int[][] neighbors = new int[count][];
        float[][] weights = new float[count][];
        NeighborFilter.add(points, reach, new PointGroups(points, reach),
                (p, q) -> points.primitive[p] == points.primitive[q] ? PointWeight.flat(points, q, Math.min(reach[p], reach[q]),
                        points.px[p], points.py[p], points.pz[p], points.nx[p], points.ny[p], points.nz[p]) : 0,
                number, neighbors, weights, workers, progress);
        return PointFilter.of(neighbors, weights);
    }
}
