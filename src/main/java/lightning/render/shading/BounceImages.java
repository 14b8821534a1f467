package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;

/**
 * What the rays bring that go on from a level's rows: red, green and blue columns each.
 *
 * @param mirrored  Cr of the reflective rows
 * @param refracted Ct of the clear rows; null where there are none
 */
public record BounceImages(float[][] mirrored, float[][] refracted) {
    // Arrays in a record: written once by their maker, never after.

    /** The colors that rays bring which go on in one way. */
    public float[][] forBounce(BounceKind bounce) {
        return switch (bounce) {
            case MIRRORED -> mirrored;
            case REFRACTED -> refracted;
        };
    }

    /** Copies that are just long enough for the rows. */
    public BounceImages compact(HitRows rows) {
        return new BounceImages(copy(mirrored, rows.reflectiveCount),
                rows.transparentCount == 0 ? null : copy(refracted, rows.transparentCount));
    }

    private static float[][] copy(float[][] columns, int rows) {
        return Arrays.stream(columns).map(column -> Arrays.copyOf(column, HitRows.paddedLength(rows))).toArray(float[][]::new);
    }

    /** The bytes of the columns, array headers left out. */
    public long bytes() {
        return 12L * mirrored[0].length + (refracted == null ? 0 : 12L * refracted[0].length);
    }
}
