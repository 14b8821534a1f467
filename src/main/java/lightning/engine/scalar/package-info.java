/** {@link lightning.engine.scalar.ScalarEngine}: rays one by one, the lighting equation in plain loops. */
package lightning.engine.scalar;
