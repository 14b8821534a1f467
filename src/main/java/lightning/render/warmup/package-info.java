/**
 * Transition of a process from the engine that is fast immediately to the one that is fastest when compiled:
 * {@link lightning.render.warmup.WarmUp}.
 */
@NullMarked
package lightning.render.warmup;

import org.jspecify.annotations.NullMarked;
