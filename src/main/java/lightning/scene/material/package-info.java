/**
 * Materials and their attributes.
 * Shading belongs to {@code render.shading}.
 */
@NullMarked
package lightning.scene.material;

import org.jspecify.annotations.NullMarked;
