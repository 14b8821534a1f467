package lightning.shading;

import java.util.Arrays;
import lightning.trace.HitRows;

/**
 * A sum of lights' contributions over the rows of a tile: red, green and blue columns.
 */
final class SumRows {
    final float[][] diffuse;
    /** Null where no specular term will ever be stored. */
    final float[][] specular;
    /** Whether any light summed here has specular terms; else those columns are undefined. */
    boolean hasSpecular;

    private SumRows(float[][] diffuse, float[][] specular, boolean hasSpecular) {
        this.diffuse = diffuse;
        this.specular = specular;
        this.hasSpecular = hasSpecular;
    }

    /** Columns for the rows of any tile. */
    static SumRows scratch() {
        return new SumRows(new float[3][Terms.ROWS], new float[3][Terms.ROWS], false);
    }

    /** A copy that is just long enough. */
    SumRows compact(int rows) {
        return new SumRows(copy(diffuse, rows), hasSpecular ? copy(specular, rows) : null, hasSpecular);
    }

    private static float[][] copy(float[][] columns, int rows) {
        return Arrays.stream(columns).map(column -> Arrays.copyOf(column, HitRows.padded(rows))).toArray(float[][]::new);
    }

    /** The bytes of the columns, array headers left out. */
    long bytes() {
        return (specular == null ? 12L : 24L) * diffuse[0].length;
    }
}
