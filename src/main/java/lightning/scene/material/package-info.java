/**
 * Materials and their attributes.
 * How a material scatters light belongs to {@code render.shading}.
 */
@NullMarked
package lightning.scene.material;

import org.jspecify.annotations.NullMarked;
