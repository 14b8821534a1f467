package lightning.scene;

import lightning.base.math.Vec3;

/**
 * A directional lamp that stands for a part of a sky.
 *
 * @param direction the unit direction to it, before the sky is turned
 * @param spread  degrees, 0 … 90: of the even cap of sky whose light has as long a mean direction as the part's
 * @param red     radiance over its solid angle, over π: what white paper that faces it shines with; likewise {@code green}, {@code blue}
 */
public record EnvironmentLight(Vec3 direction, double spread, double red, double green, double blue) {}
