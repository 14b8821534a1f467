/**
 * Images: the linear film that a renderer fills, its view transform for display, and measures that compare two films.
 * Files of images belong to {@code format.image}.
 *
 * <p>Colors are linear RGB of the sRGB primaries, unclamped, until {@link lightning.render.image.ViewTransform} clamps them. Pixel
 * (0, 0) is the top left one.
 */
@NullMarked
package lightning.render.image;

import org.jspecify.annotations.NullMarked;
