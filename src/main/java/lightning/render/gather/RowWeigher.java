package lightning.render.gather;

import java.util.Arrays;
import lightning.render.trace.HitRows;

/** Finds the gather points of rows. Holds scratch memory: use one instance per thread. */
public final class RowWeigher {
    /** Rows whose points are searched together. */
    private static final int CHUNK = 64;
    private static final int BEST = RowWeights.PER_ROW;
    private static final int MAX_WEIGHT = 255;
    private static final int MAX_ROWS = 1024;

    private final GatherStructure structure;
    private final SurfaceColumns points;
    private final float[] radius;
    private final PointGroups groups;
    private final int[] found;
    /** Index of each point among those used by the present rows. */
    private final int[] indexOf;
    /** Number of the rows for which {@link #indexOf} holds. */
    private final int[] usedBy;
    private int call;
    private final int[] used = new int[BEST * MAX_ROWS];
    private int usedCount;
    private final float[] box = new float[6];
    private final int[] best = new int[BEST + 1];
    private final float[] bestWeight = new float[BEST + 1];

    public RowWeigher(GatherStructure structure) {
        this.structure = structure;
        points = structure.points().surface();
        radius = structure.points().radius();
        groups = structure.points().groups();
        found = new int[points.count];
        indexOf = new int[points.count];
        usedBy = new int[points.count];
    }

    /** Returns the weights of up to 1024 rows. */
    public RowWeights weigh(HitRows rows) {
        call++;
        usedCount = 0;
        short[] index = new short[BEST * rows.count];
        byte[] weight = new byte[BEST * rows.count];
        for (int from = 0; from < rows.count && points.count > 0; from += CHUNK) {
            int to = Math.min(rows.count, from + CHUNK);
            bound(rows, from, to);
            int count = groups.find(box, found);
            for (int row = from; row < to; row++) {
                weigh(rows, row, count, index, weight);
            }
        }
        return new RowWeights(structure, Arrays.copyOf(used, usedCount), index, weight);
    }

    private void bound(HitRows rows, int from, int to) {
        bound(rows.px, from, to, 0);
        bound(rows.py, from, to, 1);
        bound(rows.pz, from, to, 2);
    }

    private void bound(float[] places, int from, int to, int axis) {
        float least = places[from];
        float greatest = least;
        for (int i = from + 1; i < to; i++) {
            least = Math.min(least, places[i]);
            greatest = Math.max(greatest, places[i]);
        }
        box[axis] = least;
        box[3 + axis] = greatest;
    }

    private void weigh(HitRows rows, int row, int candidates, short[] index, byte[] weight) {
        Arrays.fill(bestWeight, 0);
        for (int i = 0; i < candidates; i++) {
            int p = found[i];
            float w = PointWeight.at(points, p, radius[p], rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                    rows.nz[row]);
            if (w > bestWeight[BEST]) {
                insert(p, w);
            }
        }
        int at = BEST * row;
        if (bestWeight[0] == 0) {
            index[at] = index(groups.nearest(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row]));
            weight[at] = (byte) MAX_WEIGHT;
            return;
        }
        // The weight of the next point is subtracted, so that nothing jumps where it replaces another.
        float scale = MAX_WEIGHT / (bestWeight[0] - bestWeight[BEST]);
        for (int i = 0; i < BEST; i++) {
            int w = bestWeight[0] > bestWeight[BEST] ? (int) ((bestWeight[i] - bestWeight[BEST]) * scale + 0.5f) : MAX_WEIGHT;
            if (w > 0) {
                index[at + i] = index(best[i]);
                weight[at + i] = (byte) Math.min(MAX_WEIGHT, w);
            }
        }
    }

    /** Inserts a point among the best, after those of equal weight. */
    private void insert(int p, float w) {
        int at = BEST;
        while (at > 0 && bestWeight[at - 1] < w) {
            bestWeight[at] = bestWeight[at - 1];
            best[at] = best[at - 1];
            at--;
        }
        bestWeight[at] = w;
        best[at] = p;
    }

    private short index(int p) {
        if (usedBy[p] != call) {
            usedBy[p] = call;
            indexOf[p] = usedCount;
            used[usedCount++] = p;
        }
        return (short) indexOf[p];
    }
}
