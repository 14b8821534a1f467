package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Colors that bounced rays bring to a level's rows: red, green and blue columns each.
 *
 * @param mirrored  Cr of the reflective rows
 * @param refracted Ct of the clear rows; null if there are none
 */
public record BounceImages(float[][] mirrored, float @Nullable [][] refracted) {
    // Arrays in a record: written once by their creator, never after.

    /** Returns copies that are just long enough for the rows. */
    public BounceImages compact(HitRows rows) {
        return new BounceImages(copy(mirrored, rows.reflectiveCount),
                rows.clearCount == 0 ? null : copy(requireNonNull(refracted), rows.clearCount));
    }

    private static float[][] copy(float[][] columns, int rows) {
        return Arrays.stream(columns).map(column -> Arrays.copyOf(column, HitRows.paddedLength(rows))).toArray(float[][]::new);
    }

    /** Returns the bytes of the columns, without array headers. */
    public long bytes() {
        return 12L * mirrored[0].length + (refracted == null ? 0 : 12L * refracted[0].length);
    }
}
