/** Rays aimed at small glowing objects, and the light that points receive along them. */
@NullMarked
package lightning.render.gather.glow;

import org.jspecify.annotations.NullMarked;
