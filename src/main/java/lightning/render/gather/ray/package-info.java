/** Rays of points on surfaces: their sources, and the surfels that they hit. */
@NullMarked
package lightning.render.gather.ray;

import org.jspecify.annotations.NullMarked;
