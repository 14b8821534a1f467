package lightning.textures;

import lightning.base.math.Rgb;

/** A surface over the unit square that repeats with period 1 in both directions. */
@FunctionalInterface
interface TexturePattern {

    /** The surface at u to the right and v downwards, both in [0, 1). */
    Sample at(double u, double v);

    /**
     * One point of a surface.
     *
     * @param color display color, 0…1 a channel; values outside are clamped at the end
     * @param height above the ground, in widths of the texture; its slopes are lit from the upper left
     */
    record Sample(Rgb color, double height) {}
}
