/**
 * Diffuse indirect light, its geometric part: where light is gathered, and from where it comes. It depends on shapes and the camera
 * alone, so an edit of lights keeps it. Entry point: {@link lightning.render.gather.GatherBuilder}.
 */
@NullMarked
package lightning.render.gather;

import org.jspecify.annotations.NullMarked;
