package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.ClearMaterialShader;
import lightning.render.shading.LightWeight;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.PrincipledMaterial;
import lightning.render.shading.PrincipledRow;
import lightning.render.shading.PrincipledWeights;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.WeightedLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Refraction;
import org.jspecify.annotations.Nullable;

/**
 * Contribution of one light to single rows, without ambience and glow, by the {@link LightingEquation} itself. Used for the few rows of a
 * thumbnail, where processing all rows would be wasted. The bits are those of a picture that has only this light.
 */
public final class RowContribution {
    private final ShadingMaterial[] shadingMaterials;
    private final float[] tint = new float[3];
    private final PrincipledWeights weights = new PrincipledWeights();
    private final PrincipledRow colors = new PrincipledRow();

    public RowContribution(MaterialTable materials) {
        shadingMaterials = new ShadingMaterial[materials.count()];
        Arrays.setAll(shadingMaterials, m -> ShadingMaterial.of(materials, m));
    }

    /** Returns whether a light contributes nothing to any row of a layer. */
    public static boolean isZero(WeightedLight light, @Nullable LightLayer layer) {
        return light.isDark() || layer == null || layer.litCount() == 0;
    }

    /**
     * Computes the color of one light's contribution to a row.
     *
     * @param material the row's material
     * @param layer    the light's layer over the rows; unread if the light is dark
     * @param indirect the light's indirect light of the row: red, green, blue, then what a principled row reflects if anything blurs its
     *                 reflections; null if there is none
     * @param mirrored red, green and blue contributions of the row's mirrored ray at {@code from}, 0 if there is none; {@code
     *                 refracted} has the same layout
     * @param to       receives the row's color at {@code at}
     */
    public void color(HitRows rows, int row, int material, WeightedLight light, LightLayer layer, float @Nullable [] indirect,
            float[] mirrored, float[] refracted, int from, float[] to, int at) {
        ShadingMaterial shading = shadingMaterials[material];
        boolean isZero = isZero(light, layer);
        float fresnel = 0;
        if (shading.clarity() != null) {
            fresnel = Refraction.fresnelReflectance(shading.clarity(), rows.isInside(row), rows.nx[row], rows.ny[row], rows.nz[row],
                    rows.vx[row],
                    rows.vy[row], rows.vz[row]);
            assert shading.interior() != null && rows.insideDistance != null;
            shading.interior().write(rows.insideDistance[row], tint);
        }
        if (shading.principled() != null) {
            colors.start(shading, rows);
            colors.moveTo(row);
            weights.moveTo(shading.principled(), colors.surface(), rows, row);
        }
        // Not a loop: a compiled loop reads the length of an absent column before it checks for null, a fault of the virtual machine.
        writeChannel(0, rows, row, shading, isZero, light, layer, indirect, fresnel, mirrored, refracted, from, to, at);
        writeChannel(1, rows, row, shading, isZero, light, layer, indirect, fresnel, mirrored, refracted, from, to, at);
        writeChannel(2, rows, row, shading, isZero, light, layer, indirect, fresnel, mirrored, refracted, from, to, at);
    }

    private void writeChannel(int c, HitRows rows, int row, ShadingMaterial shading, boolean isZero, WeightedLight light, LightLayer layer,
            float @Nullable [] indirect, float fresnel, float[] mirrored, float[] refracted, int from, float[] to, int at) {
        float texel = shading.isTextured() ? requireNonNull(rows.texel(c))[row] : 1;
        float diffuse = 0;
        float specular = 0;
        float grazing = 0;
        float ks = shading.specular()[c];
        if (!isZero) {
            diffuse = diffuse(light, layer, rows, row, c);
            specular = shading.hasSpecular() ? specular(light, layer, rows, row, c) : 0;
            if (shading.texturedF0() != null) {
                grazing = grazing(light, layer, rows, row, c);
                ks += shading.isTextured() ? texel * shading.texturedF0()[c] : shading.texturedF0()[c];
            }
        }
        diffuse = indirect == null ? diffuse : indirect[c] + diffuse;
        PrincipledMaterial principled = shading.principled();
        if (principled != null) {
            to[at + c] = weights.color(principled, c, 0, colors.diffuse(c), diffuse, colors.f0(c), colors.square(c),
                    weights.specular(principled, specular, reflected(indirect, 3 + c), mirrored[from + c]),
                    weights.grazing(principled, grazing, reflected(indirect, 3 + c), reflected(indirect, 6 + c), mirrored[from + c]),
                    weights.passing(principled, c, reflected(indirect, 6 + c)));
            return;
        }
        float kd = shading.isTextured() ? texel * shading.diffuse()[c] : shading.diffuse()[c];
        to[at + c] = shading.clarity() == null
                ? LightingEquation.color(0, kd, diffuse, ks, specular, grazing, shading.reflective()[c], mirrored[from + c])
                : LightingEquation.clearColor(0, kd, diffuse, ks, specular, grazing, shading.reflective()[c], mirrored[from + c],
                        shading.bodyShare(), fresnel, ClearMaterialShader.channel(shading.clarity().color(), c), refracted[from + c],
                        tint[c]);
    }

    private static float reflected(float @Nullable [] indirect, int at) {
        return indirect == null || indirect.length == 3 ? 0 : indirect[at];
    }

    private static float diffuse(WeightedLight light, LightLayer layer, HitRows rows, int row, int c) {
        return switch (layer) {
            case LightRows l -> term(light.diffuse(), light, l, l.cosine, l.face, rows, row, c);
            case WeightedLayer w -> column(w.diffuse, row, c);
        };
    }

    private static float specular(WeightedLight light, LightLayer layer, HitRows rows, int row, int c) {
        return switch (layer) {
            case LightRows l -> term(light.specular(), light, l, l.specular, l.highlight, rows, row, c);
            case WeightedLayer w -> column(w.specular, row, c);
        };
    }

    private static float grazing(WeightedLight light, LightLayer layer, HitRows rows, int row, int c) {
        return switch (layer) {
            case LightRows l -> term(light.specular(), light, l, l.grazing, l.highlight, rows, row, c);
            case WeightedLayer w -> column(w.grazing, row, c);
        };
    }

    private static float term(LightWeight weight, WeightedLight light, LightRows layer, float @Nullable [] term,
            float @Nullable [][] colors, HitRows rows, int row, int c) {
        float tint = layer.factor(colors, c, row);
        return term == null ? 0 : LightingEquation.contribution(weight.channel(c), term[row],
                layer.falloff == null ? 1 : layer.falloff[row],
                light.gains() == null ? tint : tint * light.gains().of(requireNonNull(rows.owner)[row]));
    }

    private static float column(float @Nullable [][] columns, int row, int c) {
        return columns == null ? 0 : columns[c][row];
    }
}
