/**
 * Matching of a reference: which intensities and colors of lights come closest to an image. Contributions of lights are linear, so this is a
 * non-negative least-squares problem with one or three unknowns per light (Schoeneman et al., Painting with Light, SIGGRAPH 1993).
 */
@NullMarked
package lightning.render.match;

import org.jspecify.annotations.NullMarked;
