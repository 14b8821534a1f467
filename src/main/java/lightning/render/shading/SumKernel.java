package lightning.render.shading;

import lightning.render.trace.HitRows;

/**
 * Adds lights' contributions over the rows of a tile and closes the {@link LightingEquation}. Columns are as long as
 * {@link HitRows#paddedLength}, so that loops may run over the end.
 */
public interface SumKernel {
    /** Writes a sum: red, green and blue columns. */
    void sum(int rows, SumOperands addends, float[][] to);

    /**
     * Writes {@link LightingEquation#color} of the rows of a run. Where there is no specular term and no mirror image, it is
     * left out, which changes no bit, because it would add +0 or multiply by 1. Rows before and behind the run may get any color.
     * All that has colors is red, green and blue columns.
     *
     * @param material    that of the run's material
     * @param ambience that of the scene
     * @param diffuse  the lights' diffuse sum
     * @param specular their specular sum; null where there is none, or none is shown
     * @param grazing  their grazing sum; null where there is none, or the material is not metallic
     * @param mirrored Cr; unread where the material mirrors nothing
     * @param to       gets the colors
     */
    void shade(HitRows rows, int run, ShadingMaterial material, float ambience, float[][] diffuse, float[][] specular, float[][] grazing,
            float[][] mirrored, float[][] to);
}
