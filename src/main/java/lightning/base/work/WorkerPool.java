package lightning.base.work;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Phaser;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Fixed-size thread pool that distributes the tiles of an image: each free thread takes the next tile.
 *
 * <p>The caller's thread is worker 0. The result does not depend on the assignment of tiles to threads.
 */
public final class WorkerPool implements AutoCloseable {
    /** Work on one tile. */
    @FunctionalInterface
    public interface TileTask {
        /** Processes tile {@code tile} as worker {@code worker}, 0 ≤ worker &lt; {@link WorkerPool#count()}. */
        void run(int worker, int tile);
    }

    /** Phase of a run that is still active. */
    private static final int RUNNING_PHASE = 0;

    private final int count;
    private final ExecutorService threads;

    /**
     * @param count number of threads, including the caller's
     * @throws IllegalArgumentException if it is below 1
     */
    public WorkerPool(int count) {
        if (count < 1) {
            throw new IllegalArgumentException("the number of threads must be ≥ 1, was " + count);
        }
        this.count = count;
        threads = Executors.newFixedThreadPool(Math.max(1, count - 1), DedicatedThread.factory("lightning-worker"));
    }

    /** Returns the number of processors. */
    public static int processorCount() {
        return Runtime.getRuntime().availableProcessors();
    }

    public int count() {
        return count;
    }

    /**
     * Runs a task for each of {@code tiles} tiles and waits for all, even when interrupted: no thread writes to the caller's memory
     * afterwards. Does not wait for a thread that is scheduled only after the last tile was taken.
     *
     * @throws CancellationException if {@code progress} canceled the run; some tiles were then not run
     */
    public void run(int tiles, TileTask task, Progress progress) {
        AtomicInteger next = new AtomicInteger();
        AtomicInteger done = new AtomicInteger();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Progress shared = shareCancellation(progress);
        // Parties: the caller and every thread that started before the caller ran out of tiles. Terminates when all have arrived.
        Phaser phaser = new Phaser(1);
        int helpers = Math.min(count, tiles) - 1;
        for (int worker = 1; worker <= helpers; worker++) {
            int workerIndex = worker;
            threads.execute(() -> {
                if (phaser.register() == RUNNING_PHASE) {
                    work(workerIndex, tiles, next, done, task, shared, failure);
                }
                phaser.arriveAndDeregister();
            });
        }
        work(0, tiles, next, done, task, shared, failure);
        phaser.arriveAndAwaitAdvance();
        switch (failure.get()) {
            case null -> {
                if (done.get() < tiles) {
                    throw new CancellationException("canceled after " + done + " of " + tiles + " tiles");
                }
            }
            case RuntimeException e -> throw e;
            case Error e -> throw e;
            case Throwable e -> throw new IllegalStateException(e);
        }
    }

    /** Shares a cancellation seen by one worker with all: an interrupted caller that waits no longer appears interrupted to the others. */
    private static Progress shareCancellation(Progress progress) {
        AtomicBoolean canceled = new AtomicBoolean();
        return new Progress() {
            @Override
            public void report(int done, int total) {
                progress.report(done, total);
            }

            @Override
            public boolean isCanceled() {
                if (!canceled.get() && progress.isCanceled()) {
                    canceled.set(true);
                }
                return canceled.get();
            }
        };
    }

    private static void work(int worker, int tiles, AtomicInteger next, AtomicInteger done, TileTask task,
            Progress progress, AtomicReference<Throwable> failure) {
        try {
            for (int tile = next.getAndIncrement(); tile < tiles && failure.get() == null; tile = next.getAndIncrement()) {
                if (progress.isCanceled()) {
                    return;
                }
                task.run(worker, tile);
                if (progress.isCanceled()) {
                    return;
                }
                progress.report(done.incrementAndGet(), tiles);
            }
        } catch (Throwable e) {
            failure.compareAndSet(null, e);
        }
    }

    @Override
    public void close() {
        threads.shutdownNow();
    }
}
