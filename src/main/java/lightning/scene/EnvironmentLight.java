package lightning.scene;

import lightning.base.math.Vec3;

/**
 * Directional light that represents a region of an environment map.
 *
 * @param direction unit direction to the light, before the environment's rotation
 * @param spread    degrees, 0 … 90: half-angle of the uniform cap whose mean direction is as long as the region's
 * @param red       radiance times solid angle over π: the radiance of white paper that faces the light
 * @param green     as {@code red}
 * @param blue      as {@code red}
 */
public record EnvironmentLight(Vec3 direction, double spread, double red, double green, double blue) {}
