package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.HitRows;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.PrincipledColors;
import org.jspecify.annotations.Nullable;

/** Numbers and colors of rows of an opaque principled material, with its texture and its maps. One instance per thread. */
public final class PrincipledRow {
    private final MappedSurface surface = new MappedSurface();
    private final float[] plainDiffuse = new float[3];
    private final float[] plainMetalF0 = new float[3];
    private final float[] plainSpecular = new float[3];
    /** Columns of texture colors; unread without a texture. */
    private final float[][] texels = new float[3][0];
    private boolean isTextured;
    private boolean hasColorMap;
    private @Nullable PrincipledColors colors;
    private final float[] diffuse = new float[3];
    private final float[] f0 = new float[3];
    private final float[] square = new float[3];

    /** Sets the material of the next rows. @param shading properties of the same material */
    public void start(Bsdf.Principled principled, ShadingMaterial shading, HitRows rows) {
        colors = principled.colors();
        surface.start(principled.material(), rows);
        isTextured = shading.isTextured();
        hasColorMap = principled.hasColorMap();
        for (int c = 0; c < 3; c++) {
            plainDiffuse[c] = shading.diffuse()[c];
            plainMetalF0[c] = shading.texturedF0()[c];
            plainSpecular[c] = shading.specular()[c];
            texels[c] = isTextured ? requireNonNull(rows.texel(c)) : texels[c];
            square[c] = principled.colors().square(c, surface, 1);
        }
    }

    /** Moves to a row of the material. */
    public void moveTo(int row) {
        surface.moveTo(row);
        for (int c = 0; c < 3; c++) {
            float texel = isTextured ? texels[c][row] : 1;
            if (hasColorMap) {
                diffuse[c] = requireNonNull(colors).diffuse(c, surface) * texel;
                f0[c] = requireNonNull(colors).f0(c, surface, texel);
            } else {
                diffuse[c] = plainDiffuse[c] * texel;
                f0[c] = plainMetalF0[c] * texel + plainSpecular[c];
            }
            if (hasColorMap || isTextured) {
                square[c] = requireNonNull(colors).square(c, surface, texel);
            }
        }
    }

    /** Returns the numbers of the row. */
    public MappedSurface surface() {
        return surface;
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
