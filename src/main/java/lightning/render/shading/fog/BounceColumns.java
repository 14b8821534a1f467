package lightning.render.shading.fog;

import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Light of lamps of weight 1 in the fog along the rays that bounce from a level's rows to another level.
 *
 * @param above   rows from which they bounce
 * @param below   rows that they hit
 * @param sources light of the fog that each column was looked up in; null for none
 * @param columns light of each lamp by row: {@code float[rows]} each; null for lamps that are dark there
 */
public record BounceColumns(HitRows above, HitRows below, @Nullable FogLight[] sources, float[] @Nullable [] columns) {
    // Arrays in a record: written once by their creator, never after.

    /** Returns whether they are those of rays between the same rows. */
    boolean areBetween(HitRows from, HitRows to) {
        return above == from && below == to;
    }

    /** Returns the index of the column that was looked up in a light; −1 if there is none. */
    int index(FogLight light) {
        for (int i = 0; i < sources.length; i++) {
            if (sources[i] == light) {
                return i;
            }
        }
        return -1;
    }

    /** Returns the bytes of the columns. */
    public long bytes() {
        long bytes = 0;
        for (float[] column : columns) {
            bytes += column == null ? 0 : 4L * column.length;
        }
        return bytes;
    }
}
