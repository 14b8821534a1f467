package lightning.render.shading.composition;

import java.util.Arrays;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;

/** Runs of rows whose parents follow each other, to copy a level's colors to its parents for many films. One instance per thread. */
final class ParentRuns {
    private final short[] starts = new short[TermKernel.MAX_ROWS + 1];
    private int count;
    private short[] parent = {};

    /** Finds the runs of a level; none crosses a material. */
    void set(HitRows rows) {
        parent = rows.parent;
        count = 0;
        for (int run = 0; run < rows.runCount; run++) {
            int start = rows.runStart(run);
            for (int i = start; i < rows.runEnd[run]; i++) {
                if (i == start || parent[i] != parent[i - 1] + 1) {
                    starts[count++] = (short) i;
                }
            }
        }
        starts[count] = (short) rows.count;
    }

    /** Writes the colors of rows {@code from … end − 1}, which are all of some materials, to their parents. */
    void scatter(int from, int end, float[][] colors, float[][] to) {
        int run = Arrays.binarySearch(starts, 0, count, (short) from);
        for (; run < count && starts[run] < end; run++) {
            int row = starts[run];
            int length = starts[run + 1] - row;
            int first = parent[row];
            for (int c = 0; c < 3; c++) {
                for (int i = 0; i < length; i++) {
                    to[c][first + i] = colors[c][row + i];
                }
            }
        }
    }
}
