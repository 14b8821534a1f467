package lightning.scene.asset;

import lightning.base.math.Vec3;

/**
 * Directional light that represents a region of an environment map.
 *
 * @param direction  unit direction to the light, before the environment's rotation
 * @param meanLength 0 … 1: length of the mean of the directions of the region's light. White paper that faces a region above its horizon has
 *                   the radiance times this length
 * @param spread     degrees, 0 … 90: half-angle of the uniform cap whose mean direction is as long
 * @param red        radiance times solid angle over π
 * @param green      as {@code red}
 * @param blue       as {@code red}
 */
public record EnvironmentLight(Vec3 direction, double meanLength, double spread, double red, double green, double blue) {}
