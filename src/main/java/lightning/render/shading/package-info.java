/**
 * Lighting equation (paper §2.2), once in readable form and once as loops over columns.
 *
 * <p>{@link lightning.render.shading.LightingEquation} is the equation. {@code ReferenceTracer}, among the tests, is the
 * reference that follows §2.1 of the paper literally. Engines implement {@link lightning.render.shading.TermKernel} and {@link
 * lightning.render.shading.SumKernel} over all rows of a tile. They agree in every bit because all of them round to float at the
 * same places: point, normal, view direction, material colors, light weight, cosine, specular term and falloff. Between two
 * roundings all arithmetic is in double. After the last rounding it is in float, grouped as {@code weight·(cosine·falloff)} and
 * summed over the lights as a balanced pairwise tree in scene order.
 */
@NullMarked
package lightning.render.shading;

import org.jspecify.annotations.NullMarked;
