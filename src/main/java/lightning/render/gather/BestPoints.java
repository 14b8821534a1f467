package lightning.render.gather;

import java.util.Arrays;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.LinearWeights;
import lightning.render.gather.point.WeightedPoints;
import org.jspecify.annotations.Nullable;

/**
 * Points of the largest weights at one place after the other, and their entries in the weights of rows. Holds scratch memory: use one instance
 * per thread.
 */
final class BestPoints {
    private static final int COUNT = RowWeights.PER_ROW;
    private static final int MAX_ROWS = 1024;

    /** Index of each point among those used by the present rows. */
    private final int[] indexOf;
    /** Number of the rows for which {@link #indexOf} holds. */
    private final int[] usedBy;
    private int call;
    private final int[] used = new int[COUNT * MAX_ROWS];
    private int usedCount;
    private final int[] best = new int[COUNT + 1];
    private final float[] weight = new float[COUNT + 1];
    private final LinearWeights linear = new LinearWeights();

    /** @param points number of all points */
    BestPoints(int points) {
        indexOf = new int[points];
        usedBy = new int[points];
    }

    /** Begins rows that share a list of points. */
    void startRows() {
        call++;
        usedCount = 0;
    }

    /** Begins a place, without points. */
    void startPlace() {
        Arrays.fill(weight, 0);
    }

    /** Returns whether a weight is among the largest. */
    boolean isAmong(float w) {
        return w > weight[COUNT];
    }

    /** Returns whether no point has a weight at the place. */
    boolean isEmpty() {
        return weight[0] == 0;
    }

    /** Inserts a point among the best, after those of equal weight. */
    void insert(int p, float w) {
        int at = COUNT;
        while (at > 0 && weight[at - 1] < w) {
            weight[at] = weight[at - 1];
            best[at] = best[at - 1];
            at--;
        }
        weight[at] = w;
        best[at] = p;
    }

    /** Returns the points that the present rows use. */
    int[] used() {
        return Arrays.copyOf(used, usedCount);
    }

    /**
     * Writes one point as the only one of a row.
     *
     * @param number of the point among all
     */
    void writeOnly(int row, int number, short[] index, byte[] weights) {
        index[COUNT * row] = index(number);
        weights[COUNT * row] = (byte) WeightedPoints.MAX_WEIGHT;
    }

    /**
     * Writes the points of a place at which there is one, with weights of local linear regression.
     *
     * @param number number of each point among all; null if points are numbers
     */
    void write(int row, SurfaceColumns points, float[] radius, int @Nullable [] number, float x, float y, float z, float nx, float ny,
            float nz, short[] index,
            byte[] weights) {
        linear.start(nx, ny, nz, radius[best[0]]);
        for (int i = 0; i < COUNT && weight[i] > 0; i++) {
            // The weight of the next point is subtracted, so that nothing jumps where it replaces another.
            float w = weight[0] > weight[COUNT] ? weight[i] - weight[COUNT] : 1;
            int p = best[i];
            linear.add(w, points.px[p] - x, points.py[p] - y, points.pz[p] - z);
        }
        linear.adjust();
        int at = COUNT * row;
        float scale = WeightedPoints.MAX_WEIGHT / linear.largest();
        for (int i = 0; i < linear.count(); i++) {
            int w = WeightedPoints.whole(linear.weight(i), scale);
            if (w > 0) {
                index[at] = index(number == null ? best[i] : number[best[i]]);
                weights[at++] = (byte) w;
            }
        }
    }

    private short index(int number) {
        if (usedBy[number] != call) {
            usedBy[number] = call;
            indexOf[number] = usedCount;
            used[usedCount++] = number;
        }
        return (short) indexOf[number];
    }
}
