package lightning.render.shading.composition;

import lightning.render.shading.TermKernel;
import org.jspecify.annotations.Nullable;

/** Sum of lights' contributions over the rows of any tile: red, green and blue columns. */
final class SumColumns {
    final float[][] diffuse = new float[3][TermKernel.MAX_ROWS];
    final float[][] specular = new float[3][TermKernel.MAX_ROWS];
    /** Null until a grazing term is stored. */
    private float @Nullable [][] grazing;
    /** True if any light in the sum has specular terms; otherwise those columns are undefined. */
    boolean hasSpecular;
    /** True if any light in the sum has grazing terms; otherwise those columns are undefined. */
    boolean hasGrazing;

    /** Returns the grazing columns, allocated on first use. */
    float[][] grazing() {
        if (grazing == null) {
            grazing = new float[3][TermKernel.MAX_ROWS];
        }
        return grazing;
    }
}
