package lightning.render.shading;

import lightning.render.trace.HitRows;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Adds lights' contributions over the rows of a tile and evaluates the {@link LightingEquation}. Columns have {@link
 * HitRows#paddedLength}, so that loops may run past the last row.
 */
public interface SumKernel {
    /** Writes the sums of rows {@code from … to − 1}: red, green and blue columns. Other rows may receive any number. */
    void sum(int from, int to, SumOperands addends, float[][] sums);

    /**
     * Writes {@link LightingEquation#color} of the rows of a run. Omits specular terms and mirror images that do not exist. This
     * changes no bit, because they would add +0 or multiply by 1. Rows before and after the run may receive any color. All colors
     * are red, green and blue columns.
     *
     * @param material the run's material
     * @param emitted  {@link EmittedLight#unmapped} of red, green and blue
     * @param diffuse  the lights' diffuse sum
     * @param specular their specular sum; null if there is none, or none is shown
     * @param grazing  their grazing sum; null if there is none, or the material is not metallic
     * @param mirrored Cr; unread if the material is not reflective
     * @param to       receives the colors
     */
    void shade(HitRows rows, int run, ShadingMaterial material, float[] emitted, float[][] diffuse, float @Nullable [][] specular,
            float @Nullable [][] grazing, float @Nullable [][] mirrored, float[][] to);

    /**
     * Writes the terms of rows {@code from … to − 1} of a transparent material that no light changes.
     *
     * @param share receives the Fresnel reflectance
     * @param tint  receives the interior tint: red, green and blue columns
     */
    void clearTerms(HitRows rows, int from, int to, Transmission clarity, InteriorTint interior, float[] share, float[][] tint);

    /**
     * Adds one channel of the light at a clear surface: writes the part of {@link LightingEquation#clearColor} that no bounced ray
     * brings, of rows {@code from … to − 1}, before the interior tint. Rows before and after may receive any number.
     *
     * @param texel    1 if the material is not textured
     * @param specular the lights' specular sum, as {@code diffuse} and {@code grazing}; 0 if there is none
     */
    void clearSurface(int from, int to, ClearChannel channel, float[] texel, float[] diffuse, float[] specular, float[] grazing,
            float[] share, float[] colors);

    /**
     * Writes one channel of {@link LightingEquation#clearColor} of rows {@code from … to − 1}. Rows before and after may receive any
     * number.
     *
     * @param hasSurface true if {@code colors} contains {@link #clearSurface}; otherwise that part is 0
     */
    void clearColor(int from, int to, ClearChannel channel, boolean hasSurface, float[] mirrored, float[] refracted, float[] share,
            float[] tint, float[] colors);
}
