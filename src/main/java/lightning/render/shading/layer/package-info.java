/** Layer of one light: its contribution to each row of a tile, and updates of it. */
@NullMarked
package lightning.render.shading.layer;

import org.jspecify.annotations.NullMarked;
