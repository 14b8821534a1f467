package lightning.render.shading.composition;

import lightning.render.shading.TermKernel;
import org.jspecify.annotations.Nullable;

/** Sum of lights' contributions over the rows of any tile: red, green and blue columns. */
final class SumColumns {
    private final float[][] diffuse = new float[3][TermKernel.MAX_ROWS];
    private final float[][] specular = new float[3][TermKernel.MAX_ROWS];
    /** Null until a grazing term is stored. */
    private float @Nullable [][] grazing;
    /** The first column of each three times, for sums that are gray. */
    private final float[][] grayDiffuse = {diffuse[0], diffuse[0], diffuse[0]};
    private final float[][] graySpecular = {specular[0], specular[0], specular[0]};
    boolean isDiffuseGray;
    boolean isSpecularGray;
    /** True if any light in the sum has specular terms; otherwise those columns are undefined. */
    boolean hasSpecular;
    /** True if any light in the sum has grazing terms; otherwise those columns are undefined. */
    boolean hasGrazing;

    float[][] diffuse() {
        return isDiffuseGray ? grayDiffuse : diffuse;
    }

    float[][] specular() {
        return isSpecularGray ? graySpecular : specular;
    }

    /** Returns the grazing columns, allocated on first use. */
    float[][] grazing() {
        if (grazing == null) {
            grazing = new float[3][TermKernel.MAX_ROWS];
        }
        return grazing;
    }
}
