/**
 * The yardstick of every saving: {@link lightning.render.fulltrace.TraditionalTracer} traces a whole picture and keeps nothing of it.
 */
package lightning.render.fulltrace;
