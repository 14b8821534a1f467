/**
 * Output transform of ACES 2 for displays of 100 nits with the primaries of Rec. 709 and sRGB encoding.
 *
 * <p>{@link lightning.render.image.aces.Aces2} evaluates the formulas; {@link lightning.render.image.aces.Aces2Table} is a fast
 * approximation. The steps follow the Academy's description (ACES 2 output transforms, technical details,
 * docs.acescentral.com/system-components/output-transforms):
 *
 * <ol>
 * <li>{@link lightning.render.image.aces.AppearanceModel}: the color becomes lightness J, colorfulness M and hue h.
 * <li>{@link lightning.render.image.aces.Tonescale}: a curve for J.
 * <li>{@link lightning.render.image.aces.ChromaCompression}: M follows J; highlights lose color, shadows gain some.
 * <li>{@link lightning.render.image.aces.HueSlice}: J and M move into the gamut of the display, at the same hue.
 * <li>The appearance model of the display, backward, and the sRGB curve.
 * </ol>
 */
@NullMarked
package lightning.render.image.aces;

import org.jspecify.annotations.NullMarked;
