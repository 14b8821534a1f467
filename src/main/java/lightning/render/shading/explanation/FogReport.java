package lightning.render.shading.explanation;

/**
 * Fog between the start of a ray and the point that it hits.
 *
 * @param transmittance share of the surface's light that passes, 0…1
 * @param surface       color of the surface without fog, linear, {@code float[3]}
 * @param adds          light that the fog scatters into the ray, linear, {@code float[3]}
 */
public record FogReport(float transmittance, float[] surface, float[] adds) {}
