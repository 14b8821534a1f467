/**
 * Microfacet lobes of rough surfaces: their directions, weights and albedos.
 * Highlights of lights belong to {@code render.shading}.
 */
@NullMarked
package lightning.render.lobe;

import org.jspecify.annotations.NullMarked;
