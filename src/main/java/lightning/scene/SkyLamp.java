package lightning.scene;

import lightning.math.Vec3;

/**
 * A directional lamp that stands for a part of a sky.
 *
 * @param towards the unit direction to it, before the sky is turned
 * @param red     radiance over its solid angle, over π: what white paper that faces it shines with; likewise {@code green}, {@code blue}
 */
public record SkyLamp(Vec3 towards, double red, double green, double blue) {}
