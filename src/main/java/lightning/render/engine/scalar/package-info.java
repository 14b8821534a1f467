/** Scalar implementation, {@link lightning.render.engine.scalar.ScalarEngine}: single rays, lighting equation in plain loops. */
@NullMarked
package lightning.render.engine.scalar;

import org.jspecify.annotations.NullMarked;
