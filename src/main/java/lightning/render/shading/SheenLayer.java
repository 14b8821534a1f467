package lightning.render.shading;

import lightning.render.lobe.SheenLobe;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Fibers over a principled surface, and the sum of what the surface below reflects. A layer keeps two sums of a light: with fibers, the second
 * one is theirs, and the first one is that of the whole surface at a reflectance of its own, Σ (f·Ispec + Igraz). Rows scale it by their albedo
 * ({@link PrincipledWeights}). This is exact for a gray reflectance of f, and keeps the energy of others.
 *
 * @param lobe    lobe of the fibers
 * @param color   share of the light that they scatter: red, green, blue
 * @param largest largest channel of the color
 * @param f0      f
 */
public record SheenLayer(SheenLobe lobe, float[] color, float largest, float f0) {
    // The array is written once by its creator, never after.

    /** Returns the fibers of a material; null for none. */
    static @Nullable SheenLayer of(Material m) {
        return !m.hasSheen() ? null
                : new SheenLayer(new SheenLobe(m.sheen().roughness()), ClearMaterialShader.channels(m.sheen().color()),
                        (float) m.sheen().color().max(), (float) m.f0UnderSheen());
    }

    /**
     * Returns the term of a light, for a surface that faces it: {@link SheenLobe#term}.
     *
     * @param vx component x of the unit direction of the ray that hit the surface
     * @param lx component x of the unit vector to the light
     */
    public float term(double nx, double ny, double nz, double vx, double vy, double vz, double lx, double ly, double lz) {
        double nv = -(nx * vx + ny * vy + nz * vz);
        double nl = nx * lx + ny * ly + nz * lz;
        return (float) lobe.term(Math.clamp(nv, 0, 1), nl, -(vx * lx + vy * ly + vz * lz));
    }

    /**
     * Returns one channel of the share of light that the surface sends back in all directions.
     *
     * @param below share without the fibers
     */
    public float meanAlbedo(int channel, float below) {
        float mean = lobe.meanAlbedo();
        return below * (1 - largest * mean) + color[channel] * mean;
    }

    /** Returns the first sum of the surface below the fibers from the terms of a light with its coat. */
    public float below(float specular, float grazing) {
        return f0 * specular + grazing;
    }
}
