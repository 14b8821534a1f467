/** Full trace without a cache, the baseline of all measured savings: {@link lightning.render.fulltrace.TraditionalTracer}. */
@NullMarked
package lightning.render.fulltrace;

import org.jspecify.annotations.NullMarked;
