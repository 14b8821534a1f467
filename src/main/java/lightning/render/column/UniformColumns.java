package lightning.render.column;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * Cache of shared float columns that hold one value for all rows, such as the normals of a plane or the falloff of a distant
 * light.
 *
 * <p>Shared columns count as zero bytes. The cache holds only recent values, and few rows have columns of their own. So all
 * shared columns take at most twice as much memory as separate columns would. Thread-safe.
 */
public final class UniformColumns {
    /**
     * Length of shared columns. It exceeds that of any other column and so identifies them; lanes that overrun the rows read
     * the same value.
     */
    static final int LENGTH = ElementType.MAX_ROWS + ElementType.LENGTH_MULTIPLE;
    private static final int MIN_ROWS = LENGTH / 2;
    private static final int SLOT_COUNT = 512;
    /** Number of adjacent slots that may hold a value. */
    private static final int PROBE_COUNT = 4;
    private static final AtomicReferenceArray<float[]> SLOTS = new AtomicReferenceArray<>(SLOT_COUNT + PROBE_COUNT);

    private UniformColumns() {}

    /**
     * Returns the shared column for the value of the first {@code count} rows; returns the given column if these differ.
     */
    public static float[] share(float[] column, int count) {
        if (count < MIN_ROWS || Arrays.mismatch(column, 0, count - 1, column, 1, count) >= 0) {
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

    /** Returns a new column of one value that rows of any tile can share. */
    public static float[] of(float value) {
        float[] column = new float[LENGTH];
        Arrays.fill(column, value);
        return column;
    }
}
