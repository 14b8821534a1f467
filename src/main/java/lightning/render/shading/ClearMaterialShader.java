package lightning.render.shading;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.render.trace.HitRows;
import lightning.scene.Transmission;

/** Evaluates the {@link LightingEquation} over the rows of a clear material. Holds scratch columns: use one instance per thread. */
final class ClearMaterialShader {
    private final SumKernel kernel;
    /** Fresnel reflectance and interior tint of each row. */
    private final float[] share = new float[TermKernel.MAX_ROWS];
    private final float[][] tint = new float[3][TermKernel.MAX_ROWS];
    /** Stand for missing columns. */
    private final float[] zeros = new float[TermKernel.MAX_ROWS];
    private final float[] ones = new float[TermKernel.MAX_ROWS];

    ClearMaterialShader(SumKernel kernel) {
        this.kernel = kernel;
        Arrays.fill(ones, 1);
    }

    /** Shades a run of rows, as {@link SumKernel#shade}, including refraction. */
    void shade(HitRows rows, int run, ShadingMaterial material, float ambience, float[][] diffuse, float[][] specular, float[][] grazing,
            BounceImages images, float[][] to) {
        int start = rows.runStart(run);
        int end = rows.runEnd[run];
        if (images.isBlack() && !material.takesLight()) {
            for (int c = 0; c < 3; c++) {
                Arrays.fill(to[c], start, end, 0);
            }
            return;
        }
        kernel.clearTerms(rows, start, end, material.clarity(), material.interior(), share, tint);
        for (int c = 0; c < 3; c++) {
            ClearChannel channel = ClearChannel.of(material, c, ambience);
            if (material.takesLight()) {
                kernel.clearSurface(start, end, channel, material.isTextured() ? rows.texel(c) : ones, diffuse[c],
                        specular == null ? zeros : specular[c], grazing == null ? zeros : grazing[c], share, to[c]);
            }
            kernel.clearColor(start, end, channel, material.takesLight(), images.mirrored()[c], images.refracted()[c], share, tint[c],
                    to[c]);
        }
    }

    /** Returns the body share of a clear surface: 1 minus its largest transmission channel. */
    static float bodyShare(Transmission clarity) {
        return 1 - (float) clarity.color().max();
    }

    /** Returns a color's channel, rounded as the equation uses it. */
    static float channel(Rgb color, int channel) {
        return (float) switch (channel) {
            case 0 -> color.r();
            case 1 -> color.g();
            default -> color.b();
        };
    }
}
