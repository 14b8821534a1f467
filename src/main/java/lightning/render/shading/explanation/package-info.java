/** Explanation of a pixel: the contributions of all lights. */
@NullMarked
package lightning.render.shading.explanation;

import org.jspecify.annotations.NullMarked;
