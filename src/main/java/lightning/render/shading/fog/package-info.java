/**
 * Light that fog scatters toward the camera, also by mirrors and glass: samples along a grid of rays and those that bounce from it, and their sums before
 * each row's surface.
 */
@NullMarked
package lightning.render.shading.fog;

import org.jspecify.annotations.NullMarked;
