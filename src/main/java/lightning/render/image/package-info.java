/**
 * The picture: the linear film a renderer fills, the view transform that makes it displayable, picture files,
 * and the measures by which two films are compared.
 *
 * <p>Colors are linear RGB of the sRGB primaries, unclamped, until {@link lightning.render.image.ViewTransform} clamps
 * them. Pixel (0, 0) is the top left one.
 */
package lightning.render.image;
