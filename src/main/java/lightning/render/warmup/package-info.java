/** {@link lightning.render.warmup.WarmUp}: how a process comes from the engine that is quick at once to the one that is fastest. */
package lightning.render.warmup;
