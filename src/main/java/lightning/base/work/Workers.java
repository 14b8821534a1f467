package lightning.base.work;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Phaser;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/**
 * A fixed number of threads that share the tiles of a picture: whoever is free takes the next.
 *
 * <p>The caller's thread is worker 0. What a picture holds does not depend on who computed which
 * tile.
 */
public final class Workers implements AutoCloseable {
    /** The work on one tile. */
    @FunctionalInterface
    public interface Task {
        /** Does tile {@code tile} as worker {@code worker}, 0 ≤ worker &lt; {@link Workers#count()}. */
        void run(int worker, int tile);
    }

    /** The phase of a team that still works. */
    private static final int BEGUN = 0;

    private final int count;
    private final ExecutorService threads;

    /**
     * @param count how many threads, the caller's included
     * @throws IllegalArgumentException if it is below 1
     */
    public Workers(int count) {
        if (count < 1) {
            throw new IllegalArgumentException("the number of threads must be ≥ 1, was " + count);
        }
        this.count = count;
        threads = Executors.newFixedThreadPool(Math.max(1, count - 1), OwnThread.named("lightning-worker"));
    }

    /** As many threads as the machine has processors. */
    public static int available() {
        return Runtime.getRuntime().availableProcessors();
    }

    public int count() {
        return count;
    }

    /**
     * Runs a task for each of {@code tiles} tiles and waits for all, even when interrupted: nobody writes to the caller's memory
     * afterwards. A thread that finds a processor only when no tile is left is not waited for.
     *
     * @throws CancellationException if {@code progress} asked to stop; some tiles were then not run
     */
    public void run(int tiles, Task task, Progress progress) {
        run(tiles, 1, task, progress);
    }

    /**
     * The same where whoever is free takes the next {@code together} tiles, in their order, and fewer at the end.
     *
     * @throws CancellationException if {@code progress} asked to stop; some tiles were then not run
     */
    public void run(int tiles, int together, Task task, Progress progress) {
        AtomicInteger next = new AtomicInteger();
        AtomicInteger done = new AtomicInteger();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Progress heard = heard(progress);
        // The caller, and whoever has begun by the time that the caller finds no tile left; it ends when all of them have arrived.
        Phaser team = new Phaser(1);
        int helpers = Math.min(count, Math.ceilDiv(tiles, together)) - 1;
        for (int worker = 1; worker <= helpers; worker++) {
            int number = worker;
            threads.execute(() -> {
                if (team.register() == BEGUN) {
                    work(number, tiles, together, next, done, task, heard, failure);
                }
                team.arriveAndDeregister();
            });
        }
        work(0, tiles, together, next, done, task, heard, failure);
        team.arriveAndAwaitAdvance();
        switch (failure.get()) {
            case null -> {
                if (done.get() < tiles) {
                    throw new CancellationException("cancelled after " + done + " of " + tiles + " tiles");
                }
            }
            case RuntimeException e -> throw e;
            case Error e -> throw e;
            case Throwable e -> throw new IllegalStateException(e);
        }
    }

    /**
     * What one worker hears, all hear: an interrupted caller that waits for the others no longer looks interrupted to them.
     */
    private static Progress heard(Progress progress) {
        AtomicBoolean stopped = new AtomicBoolean();
        return new Progress() {
            @Override
            public void tiles(int done, int total) {
                progress.tiles(done, total);
            }

            @Override
            public boolean isCancelled() {
                if (!stopped.get() && progress.isCancelled()) {
                    stopped.set(true);
                }
                return stopped.get();
            }
        };
    }

    private static void work(int worker, int tiles, int together, AtomicInteger next, AtomicInteger done, Task task,
            Progress progress, AtomicReference<Throwable> failure) {
        try {
            for (int first = next.getAndAdd(together); first < tiles; first = next.getAndAdd(together)) {
                int end = first + Math.min(together, tiles - first);
                for (int tile = first; tile < end; tile++) {
                    if (failure.get() != null || progress.isCancelled()) {
                        return;
                    }
                    task.run(worker, tile);
                    if (progress.isCancelled()) {
                        return;
                    }
                    progress.tiles(done.incrementAndGet(), tiles);
                }
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
