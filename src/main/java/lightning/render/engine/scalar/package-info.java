/** Scalar implementation, {@link lightning.render.engine.scalar.ScalarEngine}: single rays, lighting equation in plain loops. */
package lightning.render.engine.scalar;
