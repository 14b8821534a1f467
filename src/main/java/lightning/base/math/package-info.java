/**
 * Vectors, colors and transforms in double precision.
 *
 * <p>All types are immutable. Angles are in radians here, but in degrees in scene files. No method uses fused multiply-add, so that results
 * are the same on every machine and at every compilation level.
 */
@NullMarked
package lightning.base.math;

import org.jspecify.annotations.NullMarked;
