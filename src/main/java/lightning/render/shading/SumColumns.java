package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.HitRows;

/**
 * A sum of lights' contributions over the rows of a tile: red, green and blue columns.
 */
final class SumColumns {
    final float[][] diffuse;
    /** Null where no specular term will ever be stored. */
    final float[][] specular;
    /** Null where no grazing term was stored yet. */
    float[][] grazing;
    /** Whether any light summed here has specular terms; else those columns are undefined. */
    boolean hasSpecular;
    /** Whether any has grazing terms; else those columns are undefined. */
    boolean hasGrazing;

    private SumColumns(float[][] diffuse, float[][] specular) {
        this.diffuse = diffuse;
        this.specular = specular;
    }

    /** Columns for the rows of any tile. */
    static SumColumns allocate() {
        return new SumColumns(new float[3][TermKernel.MAX_ROWS], new float[3][TermKernel.MAX_ROWS]);
    }

    /** The columns of grazing terms of scratch columns. */
    float[][] grazing() {
        if (grazing == null) {
            grazing = new float[3][TermKernel.MAX_ROWS];
        }
        return grazing;
    }

    /** A copy that is just long enough. */
    SumColumns compact(int rows) {
        var compact = new SumColumns(copy(diffuse, rows), hasSpecular ? copy(specular, rows) : null);
        compact.grazing = hasGrazing ? copy(grazing, rows) : null;
        compact.hasSpecular = hasSpecular;
        compact.hasGrazing = hasGrazing;
        return compact;
    }

    private static float[][] copy(float[][] columns, int rows) {
        return Arrays.stream(columns).map(column -> Arrays.copyOf(column, HitRows.paddedLength(rows))).toArray(float[][]::new);
    }

    /** The bytes of the columns, array headers left out. */
    long bytes() {
        return (12L + (specular == null ? 0 : 12L) + (grazing == null ? 0 : 12L)) * diffuse[0].length;
    }
}
