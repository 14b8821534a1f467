/**
 * Long-running work: a thread pool, background threads, progress and cancellation.
 *
 * <pre>{@code
 * try (WorkerPool workers = new WorkerPool(2)) {
 *     workers.run(tiles, (worker, tile) -> trace(tile), Progress.NONE);
 * }
 * }</pre>
 */
@NullMarked
package lightning.base.work;

import org.jspecify.annotations.NullMarked;
