package lightning.serve;

import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;

/**
 * Options of a server.
 *
 * @param threads threads that trace a picture
 * @param memory  maximum bytes of the caches of all scenes
 */
public record ServerOptions(int threads, long memory) {
    /** All processors and the memory of this Java process. */
    public static final ServerOptions DEFAULT = new ServerOptions(WorkerPool.processorCount(), HeapBudget.availableBytes());
}
