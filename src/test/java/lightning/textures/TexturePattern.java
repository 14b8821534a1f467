package lightning.textures;

import lightning.base.math.Rgb;

/** Texture over the unit square that repeats with period 1 in both directions. */
@FunctionalInterface
interface TexturePattern {

    /** Returns the texture at u to the right and v downwards, both in [0, 1). */
    Sample at(double u, double v);

    /**
     * Sample of a texture.
     *
     * @param color  display color, 0…1 per channel; other values are clamped at the end
     * @param height height above the base, in widths of the texture; its slopes are lit from the upper left
     */
    record Sample(Rgb color, double height) {}
}
