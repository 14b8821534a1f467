/**
 * The yardstick of every saving: {@link lightning.fulltrace.TraditionalTracer} traces a whole picture and keeps nothing of it.
 */
package lightning.fulltrace;
