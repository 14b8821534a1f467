package lightning.render.column;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * Columns of floats that hold one value everywhere, shared by all rows of which it is that of every one: the normals of a plane, what a
 * distant light gives it. They are counted with no rows. The newest values have a place here, and few rows have columns of their own:
 * so all that are shared never take more than twice what columns of their own would.
 * For use by any number of threads.
 */
public final class UniformColumns {
    /** Longer than any other column, by which they are known; lanes may run over the end of rows, and find the value. */
    static final int LENGTH = ElementType.MAX_ROWS + ElementType.LENGTH_MULTIPLE;
    private static final int MIN_ROWS = LENGTH / 2;
    private static final int SLOT_COUNT = 512;
    /** At how many of them a value may be, side by side. */
    private static final int PROBE_COUNT = 4;
    private static final AtomicReferenceArray<float[]> SLOTS = new AtomicReferenceArray<>(SLOT_COUNT + PROBE_COUNT);

    private UniformColumns() {}

    /** The column of which all have what stands in {@code count} rows of another; that other itself where its rows differ, or there is none. */
    public static float[] share(float[] column, int count) {
        if (column == null || count < MIN_ROWS || Arrays.mismatch(column, 0, count - 1, column, 1, count) >= 0) {
            return column;
        }
        int bits = Float.floatToRawIntBits(column[0]);
        int first = (bits * 0x9E3779B9 >>> 16) % SLOT_COUNT;
        int free = first;
        for (int slot = first; slot < first + PROBE_COUNT; slot++) {
            float[] cached = SLOTS.get(slot);
            if (cached != null && Float.floatToRawIntBits(cached[0]) == bits) {
                return cached;
            }
            free = cached == null ? slot : free;
        }
        float[] shared = of(column[0]);
        SLOTS.set(free, shared);
        return shared;
    }

    /** A new column of one value, for rows of any tile to share. */
    public static float[] of(float value) {
        float[] column = new float[LENGTH];
        Arrays.fill(column, value);
        return column;
    }
}
