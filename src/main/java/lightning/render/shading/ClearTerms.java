package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Terms of a level's clear rows that no light changes: Fresnel reflectance and interior tint. They are computed whenever a level is
 * composed. While lights are edited repeatedly, levels cache them.
 */
public final class ClearTerms {
    /** Tint of rows whose rays all came from outside: shared and not counted as memory. */
    static final float[] WHITE = new float[TermKernel.MAX_ROWS];

    static {
        Arrays.fill(WHITE, 1);
    }

    /** Transmission of each run of clear rows. */
    private final Transmission @Nullable [] transmissions;
    /** Fresnel reflectance of each clear row. */
    final float[] share;
    /** Interior tint of each clear row: red, green and blue columns. */
    final float[][] tint;

    private ClearTerms(Transmission @Nullable [] transmissions, float[] share, float[][] tint) {
        this.transmissions = transmissions;
        this.share = share;
        this.tint = tint;
    }

    /** Allocates scratch columns for the rows of any tile. */
    static ClearTerms allocate() {
        return new ClearTerms(null, new float[TermKernel.MAX_ROWS], new float[3][TermKernel.MAX_ROWS]);
    }

    /**
     * Computes the terms of all clear rows of a level.
     *
     * @param scratch receives each run's terms first, because kernels also write to rows next to a run
     */
    static ClearTerms of(HitRows rows, ShadingMaterial[] materials, SumKernel kernel, ClearTerms scratch) {
        int length = HitRows.paddedLength(rows.clearCount);
        float[] share = new float[length];
        float[][] tint = new float[3][length];
        Transmission[] transmissions = new Transmission[runCount(rows)];
        for (int run = 0; run < transmissions.length; run++) {
            ShadingMaterial material = materials[rows.runMaterial[run]];
            transmissions[run] = material.clarity();
            int start = rows.runStart(run);
            int end = rows.runEnd[run];
            kernel.clearTerms(rows, start, end, requireNonNull(material.clarity()), requireNonNull(material.interior()), scratch.share,
                    scratch.tint);
            System.arraycopy(scratch.share, start, share, start, end - start);
            for (int c = 0; c < 3; c++) {
                System.arraycopy(scratch.tint[c], start, tint[c], start, end - start);
            }
        }
        for (int c = 0; c < 3; c++) {
            if (Arrays.equals(tint[c], 0, rows.clearCount, WHITE, 0, rows.clearCount)) {
                tint[c] = WHITE;
            }
        }
        return new ClearTerms(transmissions, share, tint);
    }

    private static int runCount(HitRows rows) {
        int runs = 0;
        while (runs < rows.runCount && rows.runStart(runs) < rows.clearCount) {
            runs++;
        }
        return runs;
    }

    /** Returns whether these terms, of the same rows, are those of other materials too. */
    public boolean isFor(HitRows rows, ShadingMaterial[] materials) {
        assert transmissions != null;
        for (int run = 0; run < transmissions.length; run++) {
            if (!transmissions[run].equals(materials[rows.runMaterial[run]].clarity())) {
                return false;
            }
        }
        return true;
    }

    /** Returns the bytes of the columns, without array headers: 4 to 16 for each clear row. */
    public long bytes() {
        long bytes = 4L * share.length;
        for (float[] channel : tint) {
            bytes += channel == WHITE ? 0 : 4L * channel.length;
        }
        return bytes;
    }
}
