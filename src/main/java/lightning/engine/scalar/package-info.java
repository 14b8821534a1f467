/** {@link lightning.engine.scalar.ScalarEngine}: the lighting equation in plain loops. */
package lightning.engine.scalar;
