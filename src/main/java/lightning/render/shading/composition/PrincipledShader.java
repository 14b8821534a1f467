package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import lightning.render.shading.PrincipledMaterial;
import lightning.render.shading.PrincipledRow;
import lightning.render.shading.PrincipledWeights;
import lightning.render.shading.ShadingMaterial;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/** Shades rows of principled materials, for all engines. Holds scratch memory: use one instance per thread. */
final class PrincipledShader {
    private final PrincipledWeights weights = new PrincipledWeights();
    private final PrincipledRow colors = new PrincipledRow();

    /**
     * Writes the colors of a run's rows.
     *
     * @param specular  lights' sum of specular terms; null for none, as {@code grazing}
     * @param reflected mean light of the surroundings: three columns for what F0 multiplies, and three for what no color multiplies or
     *                  what passes a frosted material; null for none
     * @param mirrored  colors of mirrored rays; null if there are none
     */
    void shade(HitRows rows, int run, ShadingMaterial material, float[] emitted, float[][] diffuse, float @Nullable [][] specular,
            float @Nullable [][] grazing, float @Nullable [][] reflected, float @Nullable [][] mirrored, float[][] to) {
        PrincipledMaterial principled = requireNonNull(material.principled());
        colors.start(material, rows);
        for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
            colors.moveTo(i);
            weights.moveTo(principled, colors.surface(), rows, i);
            for (int c = 0; c < 3; c++) {
                float mirror = mirrored == null || !principled.isMirror() ? 0 : mirrored[c][i];
                float first = reflected == null ? 0 : reflected[c][i];
                float second = reflected == null ? 0 : reflected[3 + c][i];
                float shine = weights.specular(principled, specular == null ? 0 : specular[c][i], first, mirror);
                float graze = weights.grazing(principled, grazing == null ? 0 : grazing[c][i], first, second, mirror);
                to[c][i] = weights.color(principled, c, emitted[c], colors.diffuse(c), diffuse[c][i], colors.f0(c), colors.square(c), shine,
                        graze,
                        weights.passing(principled, c, second));
            }
        }
    }

    /** Writes the colors of a run's rows regardless of the lights. */
    void shadeUnlit(HitRows rows, int run, ShadingMaterial material, float[] emitted, float[][] to) {
        colors.start(material, rows);
        for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
            colors.moveTo(i);
            for (int c = 0; c < 3; c++) {
                to[c][i] = emitted[c] + colors.diffuse(c);
            }
        }
    }
}
