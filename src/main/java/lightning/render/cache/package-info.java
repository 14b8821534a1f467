/**
 * Pixel cache (paper §2.4): the hits and light layers of every pixel, as tiles of columns.
 * Updates belong to {@code render.relight}.
 *
 * <p>An image is divided into tiles of 32×32 pixels. A tile has one level for camera rays and one for each secondary bounce; a
 * level has its hit rows and, for each light, one layer over them. Rows map many-to-one to pixels. All objects are immutable:
 * an update creates new tiles that share every unchanged column, so that a canceled update has no effect.
 */
@NullMarked
package lightning.render.cache;

import org.jspecify.annotations.NullMarked;
