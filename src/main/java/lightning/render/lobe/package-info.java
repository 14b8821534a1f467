/** Microfacet lobes of rough surfaces: their directions, weights and albedos. */
@NullMarked
package lightning.render.lobe;

import org.jspecify.annotations.NullMarked;
