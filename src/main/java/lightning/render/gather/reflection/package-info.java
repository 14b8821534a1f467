/** Reflection points of rough surfaces: where they are, and what their rays meet. */
@NullMarked
package lightning.render.gather.reflection;

import org.jspecify.annotations.NullMarked;
