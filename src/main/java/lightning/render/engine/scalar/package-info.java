/** {@link lightning.render.engine.scalar.ScalarEngine}: rays one by one, the lighting equation in plain loops. */
package lightning.render.engine.scalar;
