package lightning.render.shading;

import lightning.base.math.PowerFunction;
import lightning.base.math.Rgb;
import lightning.render.trace.HitRows;
import lightning.render.trace.Refraction;
import lightning.scene.Transmission;

/** Evaluates the {@link LightingEquation} over the rows of a clear material, for every engine. */
final class ClearMaterialShader {
    private final float[] tint = new float[3];

    /** Shades a run of rows, as {@link SumKernel#shade}, including refraction. */
    void shade(HitRows rows, int run, ShadingMaterial material, float ambience, float[][] diffuse, float[][] specular, float[][] grazing,
            BounceImages images, float[][] to) {
        Transmission clarity = material.clarity();
        for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
            float share =
                    Refraction.fresnelReflectance(clarity, rows.isInside(i), rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i],
                            rows.vz[i]);
            interiorTint(clarity, rows.insideDistance[i], tint);
            for (int c = 0; c < 3; c++) {
                float texel = material.isTextured() ? rows.texel(c)[i] : 1;
                float metal = material.texturedF0() == null ? 0 : material.texturedF0()[c];
                to[c][i] = LightingEquation.clearColor(material.ambient()[c], ambience, material.diffuse()[c] * texel, diffuse[c][i],
                        metal * texel + material.specular()[c], specular == null ? 0 : specular[c][i], grazing == null ? 0 : grazing[c][i],
                        material.reflective()[c], images.mirrored()[c][i], material.bodyShare(), share, channel(clarity.color(), c),
                        images.refracted()[c][i], tint[c]);
            }
        }
    }

    /**
     * Writes the transmittance of a ray's path inside a solid: tint<sup>path / tint distance</sup> in red, green, blue; all 1 if it
     * came from outside.
     */
    static void interiorTint(Transmission clarity, float inside, float[] to) {
        for (int c = 0; c < 3; c++) {
            to[c] = inside >= 0 ? (float) PowerFunction.pow(channel(clarity.tint(), c), inside / clarity.tintDistance()) : 1;
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
