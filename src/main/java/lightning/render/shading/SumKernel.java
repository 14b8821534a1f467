package lightning.render.shading;

import lightning.render.gather.ray.FilmKernel;
import lightning.render.trace.HitRows;
import lightning.scene.material.Transmission;

/**
 * Adds lights' contributions over the rows of a tile and evaluates the {@link LightingEquation}. Columns have {@link
 * HitRows#paddedLength}, so that loops may run past the last row.
 */
public interface SumKernel extends FilmKernel {
    /** Writes the sums of rows {@code from … to − 1}: red, green and blue columns. Other rows may receive any number. */
    void sum(int from, int to, SumOperands addends, float[][] sums);

    /**
     * Writes the terms of rows {@code from … to − 1} of a transparent material that no light changes.
     *
     * @param share receives the Fresnel reflectance
     * @param tint  receives the interior tint: red, green and blue columns
     */
    void clearTerms(HitRows rows, int from, int to, Transmission clarity, InteriorTint interior, float[] share, float[][] tint);
}
