package lightning.render.shading.composition;

import java.util.Arrays;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/** Sum of lights' contributions over the rows of a tile: red, green and blue columns. */
final class SumColumns {
    final float[][] diffuse;
    /** Null if no specular term is ever stored. */
    final float @Nullable [][] specular;
    /** Null until a grazing term is stored. */
    float @Nullable [][] grazing;
    /** True if any light in the sum has specular terms; otherwise those columns are undefined. */
    boolean hasSpecular;
    /** True if any light in the sum has grazing terms; otherwise those columns are undefined. */
    boolean hasGrazing;

    private SumColumns(float[][] diffuse, float @Nullable [][] specular) {
        this.diffuse = diffuse;
        this.specular = specular;
    }

    /** Allocates columns for the rows of any tile. */
    static SumColumns allocate() {
        return new SumColumns(new float[3][TermKernel.MAX_ROWS], new float[3][TermKernel.MAX_ROWS]);
    }

    /** Returns the grazing columns of scratch columns, allocated on first use. */
    float[][] grazing() {
        if (grazing == null) {
            grazing = new float[3][TermKernel.MAX_ROWS];
        }
        return grazing;
    }

    private static float[][] copy(float[][] columns, int rows) {
        return Arrays.stream(columns).map(column -> Arrays.copyOf(column, HitRows.paddedLength(rows))).toArray(float[][]::new);
    }

    /** Returns the bytes of the columns, without array headers. */
    long bytes() {
        return (12L + (specular == null ? 0 : 12L) + (grazing == null ? 0 : 12L)) * diffuse[0].length;
    }
}
