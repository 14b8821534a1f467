package lightning.engine.lanes;

import lightning.shading.Addends;

/**
 * Reads a value of each line of the processor's cache, so that a column is there when lanes go over it. Lanes alone wait for
 * memory: columns are too short for the processor to see them coming, while of plain reads it has many under way at once.
 */
final class Touch {
    /** Floats in a line of the cache. */
    private static final int LINE = 16;

    /** What was read, so that it must be. */
    float read;

    /** The rows {@code start … end − 1} of a column; nothing where it is null. */
    void column(float[] column, int start, int end) {
        if (column == null) {
            return;
        }
        float a = 0;
        float b = 0;
        float c = 0;
        float d = 0;
        int i = start;
        for (; i < end - 3 * LINE; i += 4 * LINE) {
            a += column[i];
            b += column[i + LINE];
            c += column[i + 2 * LINE];
            d += column[i + 3 * LINE];
        }
        for (; i < end; i += LINE) {
            a += column[i];
        }
        read = a + b + c + d;
    }

    /** All that a sum over rows {@code 0 … rows − 1} consists of. */
    void addends(int rows, Addends addends) {
        for (int l = 0; l < addends.lights; l++) {
            column(addends.term[l], 0, rows);
            column(addends.falloff[l], 0, rows);
        }
        for (int s = 0; s < addends.sums; s++) {
            column(addends.sumRed[s], 0, rows);
            column(addends.sumGreen[s], 0, rows);
            column(addends.sumBlue[s], 0, rows);
        }
    }
}
