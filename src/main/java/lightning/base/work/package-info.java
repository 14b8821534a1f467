/**
 * Long work: threads that share it, and who hears how far it is and may stop it.
 *
 * <pre>{@code
 * try (Workers workers = new Workers(2)) {
 *     workers.run(tiles, (worker, tile) -> trace(tile), Progress.NONE);
 * }
 * }</pre>
 */
package lightning.base.work;
