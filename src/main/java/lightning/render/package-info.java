/** From a scene to a picture: what every renderer is told ({@link lightning.render.RenderOptions}). */
@NullMarked
package lightning.render;

import org.jspecify.annotations.NullMarked;
