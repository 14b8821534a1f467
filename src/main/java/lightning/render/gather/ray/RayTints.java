package lightning.render.gather.ray;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import org.jspecify.annotations.Nullable;

/**
 * Tints of the rays that pass transparent surfaces. Immutable.
 *
 * @param ray  tinted rays, ascending
 * @param tint their tints: red, green, blue
 */
public record RayTints(int[] ray, float[][] tint) {
    // Arrays in a record: written once by their creator, never after.

    /** Returns the tints of {@code rays} rays other than white; null if there are none. */
    public static @Nullable RayTints of(float[][] dense, int rays) {
        int[] ray = new int[rays];
        int count = 0;
        for (int i = 0; i < rays; i++) {
            ray[count] = i;
            count += dense[0][i] != 1 || dense[1][i] != 1 || dense[2][i] != 1 ? 1 : 0;
        }
        if (count == 0) {
            return null;
        }
        float[][] tint = new float[3][count];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < count; i++) {
                tint[c][i] = dense[c][ray[i]];
            }
        }
        return new RayTints(Arrays.copyOf(ray, count), tint);
    }

    /** Returns the index of the first tinted ray at or after one. */
    public int firstFrom(int first) {
        int found = Arrays.binarySearch(ray, first);
        return found >= 0 ? found : -found - 1;
    }

    /**
     * Writes the tints of consecutive rays, white for those without.
     *
     * @param to red, green and blue; not written if no ray is tinted
     * @return whether any is tinted
     */
    public boolean read(int from, int count, float[][] to) {
        int first = firstFrom(from);
        if (first == ray.length || ray[first] >= from + count) {
            return false;
        }
        for (int c = 0; c < 3; c++) {
            Arrays.fill(to[c], 0, count, 1);
            for (int i = first; i < ray.length && ray[i] < from + count; i++) {
                to[c][ray[i] - from] = tint[c][i];
            }
        }
        return true;
    }

    public static void write(@Nullable RayTints tints, ColumnWriter out) throws IOException {
        out.writeArray(tints == null ? null : tints.ray);
        out.writeFloatArrays(tints == null ? null : tints.tint);
    }

    /** Reads tints; returns null for none. */
    public static @Nullable RayTints read(ColumnReader in) throws IOException {
        int[] ray = in.readOptionalInts();
        float[][] tint = in.readOptionalFloatArrays();
        return ray == null || tint == null ? null : new RayTints(ray, tint);
    }

    public int count() {
        return ray.length;
    }

    public long bytes() {
        return 16L * ray.length;
    }
}
