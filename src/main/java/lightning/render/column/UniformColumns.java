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
    static final int LENGTH = ElementType.MOST_ROWS + ElementType.GRAIN;
    private static final int FEW = LENGTH / 2;
    private static final int ALL_PLACES = 512;
    /** At how many of them a value may be, side by side. */
    private static final int PLACES = 4;
    private static final AtomicReferenceArray<float[]> SHARED = new AtomicReferenceArray<>(ALL_PLACES + PLACES);

    private UniformColumns() {}

    /** The column of which all have what stands in {@code count} rows of another; that other itself where its rows differ, or there is none. */
    public static float[] shared(float[] column, int count) {
        if (column == null || count < FEW || Arrays.mismatch(column, 0, count - 1, column, 1, count) >= 0) {
            return column;
        }
        int bits = Float.floatToRawIntBits(column[0]);
        int first = (bits * 0x9E3779B9 >>> 16) % ALL_PLACES;
        int free = first;
        for (int place = first; place < first + PLACES; place++) {
            float[] known = SHARED.get(place);
            if (known != null && Float.floatToRawIntBits(known[0]) == bits) {
                return known;
            }
            free = known == null ? place : free;
        }
        float[] shared = of(column[0]);
        SHARED.set(free, shared);
        return shared;
    }

    /** A new column of one value, for rows of any tile to share. */
    public static float[] of(float value) {
        float[] column = new float[LENGTH];
        Arrays.fill(column, value);
        return column;
    }
}
