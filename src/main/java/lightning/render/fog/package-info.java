/** Fog along rays: what it transmits, and where a ray is sampled for a light. */
@NullMarked
package lightning.render.fog;

import org.jspecify.annotations.NullMarked;
