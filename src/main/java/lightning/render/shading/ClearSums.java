package lightning.render.shading;

import lightning.base.math.Power;
import lightning.base.math.Rgb;
import lightning.render.trace.HitRows;
import lightning.render.trace.Refraction;
import lightning.scene.Clarity;

/** Closes the {@link LightingEquation} over the rows of a clear material, whichever engine adds its lights. */
final class ClearSums {
    private final float[] tint = new float[3];

    /** As {@link Sums#close}, with what is seen through the surface. */
    void close(HitRows rows, int run, Shade shade, float ambience, float[][] diffuse, float[][] specular, float[][] grazing,
            Images images, float[][] to) {
        Clarity clarity = shade.clarity();
        for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
            float share = Refraction.mirrored(clarity, rows.isInside(i), rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i],
                    rows.vz[i]);
            tint(clarity, rows.inside[i], tint);
            for (int c = 0; c < 3; c++) {
                float texel = shade.textured() ? rows.texel(c)[i] : 1;
                float metal = shade.metal() == null ? 0 : shade.metal()[c];
                to[c][i] = LightingEquation.clearColor(shade.ambient()[c], ambience, shade.diffuse()[c] * texel, diffuse[c][i],
                        metal * texel + shade.specular()[c], specular == null ? 0 : specular[c][i], grazing == null ? 0 : grazing[c][i],
                        shade.reflective()[c], images.mirrored()[c][i], shade.body(), share, channel(clarity.clear(), c),
                        images.refracted()[c][i], tint[c]);
            }
        }
    }

    /**
     * Writes what is left of a ray's light after its way inside: tint<sup>way / tint distance</sup>, red, green, blue; all 1 where it
     * came from outside.
     */
    static void tint(Clarity clarity, float inside, float[] to) {
        for (int c = 0; c < 3; c++) {
            to[c] = inside >= 0 ? (float) Power.of(channel(clarity.tint(), c), inside / clarity.tintDistance()) : 1;
        }
    }

    /** How much of a clear surface is body: what its clearest channel leaves. */
    static float body(Clarity clarity) {
        return 1 - (float) clarity.clear().max();
    }

    /** A colour's channel as the equation reads it. */
    static float channel(Rgb color, int channel) {
        return (float) switch (channel) {
            case 0 -> color.r();
            case 1 -> color.g();
            default -> color.b();
        };
    }
}
