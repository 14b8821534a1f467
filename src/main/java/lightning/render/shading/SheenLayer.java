package lightning.render.shading;

import lightning.render.lobe.SheenLobe;
import lightning.render.trace.MappedSurface;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Fibers over a principled surface, and the sum of what the surface below reflects. A layer keeps two sums of a light: with fibers, the second
 * one is theirs, and the first one is that of the whole surface at a reflectance of its own, Σ (f·Ispec + Igraz). Rows scale it by their albedo
 * ({@link PrincipledWeights}). This is exact for a gray reflectance of f, and keeps the energy of others.
 *
 * @param f0 f
 */
public record SheenLayer(float f0) {

    /** Returns the fibers of a material; null for none. */
    static @Nullable SheenLayer of(Material m) {
        return m.hasSheen() ? new SheenLayer((float) m.f0UnderSheen()) : null;
    }

    /**
     * Returns the term of a light, for a surface that faces it: {@link SheenLobe#term}.
     *
     * @param roughness of the fibers
     * @param vx        component x of the unit direction of the ray that hit the surface
     * @param lx        component x of the unit vector to the light
     */
    public static float term(double roughness, double nx, double ny, double nz, double vx, double vy, double vz, double lx, double ly,
            double lz) {
        double nv = -(nx * vx + ny * vy + nz * vz);
        double nl = nx * lx + ny * ly + nz * lz;
        return (float) SheenLobe.term(roughness, Math.clamp(nv, 0, 1), nl, -(vx * lx + vy * ly + vz * lz));
    }

    /**
     * Returns one channel of the share of light that a surface with fibers sends back in all directions.
     *
     * @param at    numbers of the surface
     * @param below share without the fibers
     */
    public static float meanAlbedo(MappedSurface at, int channel, float below) {
        float mean = SheenLobe.meanAlbedo(at.sheenRoughness());
        return below * (1 - at.largestSheen() * mean) + at.sheen(channel) * mean;
    }

    /** Returns the first sum of the surface below the fibers from the terms of a light with its coat. */
    public float below(float specular, float grazing) {
        return f0 * specular + grazing;
    }
}
