package lightning.render.shading.layer;

import lightning.render.shading.SheenLayer;
import lightning.render.trace.HitRows;

/** Sheen terms of the {@link lightning.render.shading.LightingEquation}, for all engines: a table of albedos has no vector version. */
public final class SheenTerms {
    private SheenTerms() {}

    /**
     * Writes the terms, as {@link lightning.render.shading.TermKernel#sheens}.
     *
     * @param lx component x of the unit vector from each row to the light, as {@code ly} and {@code lz}
     */
    public static void write(HitRows rows, int from, int to, int[] rowSet, double[] roughness, double[] lx, double[] ly, double[] lz,
            float[] column) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                column[i] =
                        SheenLayer.term(roughness[i], rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], lx[i], ly[i],
                                lz[i]);
            }
        }
    }
}
