package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.trace.BounceKind;
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

    /** Images of rays after which the recursion ended, for any number of rows. */
    public static final BounceImages BLACK = black();

    private static BounceImages black() {
        float[] zeros = new float[TermKernel.MAX_ROWS];
        float[][] channels = {zeros, zeros, zeros};
        return new BounceImages(channels, channels);
    }

    /** Returns whether the recursion ended at these rows, so that all colors are 0. */
    boolean isBlack() {
        return this == BLACK;
    }

    /** Returns the colors of one kind of bounce. */
    public float[][] forBounce(BounceKind bounce) {
        return switch (bounce) {
            case MIRRORED -> mirrored;
            case REFRACTED -> requireNonNull(refracted);
        };
    }

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
