package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.PrincipledColors;
import org.jspecify.annotations.Nullable;

/** Roughness and colors of rows of an opaque principled material, with its texture and its maps. One instance per thread. */
public final class PrincipledRow {
    private final float[] plainDiffuse = new float[3];
    private final float[] plainMetalF0 = new float[3];
    private final float[] plainSpecular = new float[3];
    /** Columns of texture colors; unread without a texture. */
    private final float[][] texels = new float[3][0];
    private boolean isTextured;
    private @Nullable PrincipledMaterial material;
    private float @Nullable [] roughnessTexel;
    private float @Nullable [] metalnessTexel;
    private boolean isPlain;
    private float roughness;
    private final float[] diffuse = new float[3];
    private final float[] f0 = new float[3];
    private final float[] square = new float[3];

    /** Sets the material of the next rows. */
    public void start(ShadingMaterial shading, HitRows rows) {
        PrincipledMaterial principled = requireNonNull(shading.principled());
        float[] metalF0 = requireNonNull(shading.texturedF0());
        material = principled;
        isTextured = shading.isTextured();
        roughness = principled.roughness();
        roughnessTexel = principled.hasRoughnessMap() ? rows.texel(ColumnGroup.ROUGHNESS_TEXEL, 0) : null;
        metalnessTexel = principled.hasMetalnessMap() ? rows.texel(ColumnGroup.METALNESS_TEXEL, 0) : null;
        isPlain = !isTextured && metalnessTexel == null;
        for (int c = 0; c < 3; c++) {
            plainDiffuse[c] = shading.diffuse()[c];
            plainMetalF0[c] = metalF0[c];
            plainSpecular[c] = shading.specular()[c];
            texels[c] = isTextured ? requireNonNull(rows.texel(c)) : texels[c];
            square[c] = principled.colors().square(c, principled.material().metalness(), 1);
        }
    }

    /** Moves to a row of the material. */
    public void moveTo(int row) {
        if (roughnessTexel != null) {
            roughness = (float) requireNonNull(material).material().mappedRoughness(roughnessTexel[row]);
        }
        for (int c = 0; c < 3; c++) {
            float texel = isTextured ? texels[c][row] : 1;
            diffuse[c] = plainDiffuse[c] * texel;
            f0[c] = plainMetalF0[c] * texel + plainSpecular[c];
        }
        if (!isPlain) {
            mix(row);
        }
    }

    private void mix(int row) {
        PrincipledMaterial principled = requireNonNull(material);
        PrincipledColors colors = principled.colors();
        double metalness =
                metalnessTexel == null ? principled.material().metalness() : principled.material().mappedMetalness(metalnessTexel[row]);
        for (int c = 0; c < 3; c++) {
            float texel = isTextured ? texels[c][row] : 1;
            if (metalnessTexel != null) {
                diffuse[c] = colors.diffuse(c, metalness) * texel;
                f0[c] = colors.metalF0(c, metalness) * texel + colors.specular(c, metalness);
            }
            square[c] = colors.square(c, metalness, texel);
        }
    }

    /** Returns the roughness below the coat. */
    public float roughness() {
        return roughness;
    }

    /** Returns one channel of k<sub>diffuse</sub>. */
    public float diffuse(int channel) {
        return diffuse[channel];
    }

    /** Returns one channel of {@link PrincipledColors#square}. */
    public float square(int channel) {
        return square[channel];
    }

    /** Returns one channel of F0. */
    public float f0(int channel) {
        return f0[channel];
    }
}
