/**
 * Transition of a process from the engine that is fast immediately to the one that is fastest when compiled:
 * {@link lightning.render.warmup.WarmUp}.
 */
package lightning.render.warmup;
