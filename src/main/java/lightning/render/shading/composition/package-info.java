/** Sums of weighted layers, ambient light and bounces, and the edges that need finer samples. */
@NullMarked
package lightning.render.shading.composition;

import org.jspecify.annotations.NullMarked;
