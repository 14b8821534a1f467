/** Gather points: their weights at places on surfaces, the barriers around them, and means over neighbors. */
@NullMarked
package lightning.render.gather.point;

import org.jspecify.annotations.NullMarked;
