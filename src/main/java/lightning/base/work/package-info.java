/**
 * Long work: threads that share it, and who hears how far it is and may stop it.
 *
 * <pre>{@code
 * try (WorkerPool workers = new WorkerPool(2)) {
 *     workers.run(tiles, (worker, tile) -> trace(tile), Progress.NONE);
 * }
 * }</pre>
 */
package lightning.base.work;
