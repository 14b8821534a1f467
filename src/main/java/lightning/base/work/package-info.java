/**
 * Long-running work: a thread pool, background threads, progress and cancellation.
 *
 * <pre>{@code
 * try (WorkerPool workers = new WorkerPool(2)) {
 *     workers.run(tiles, (worker, tile) -> trace(tile), Progress.NONE);
 * }
 * }</pre>
 */
package lightning.base.work;
