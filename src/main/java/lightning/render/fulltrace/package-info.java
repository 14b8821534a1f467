/** Full trace without a cache, the baseline of all measured savings: {@link lightning.render.fulltrace.TraditionalTracer}. */
package lightning.render.fulltrace;
