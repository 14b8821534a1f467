/** Light that fog scatters toward the camera: samples along a grid of rays, and their sums before each pixel's surface. */
@NullMarked
package lightning.render.shading.fog;

import org.jspecify.annotations.NullMarked;
