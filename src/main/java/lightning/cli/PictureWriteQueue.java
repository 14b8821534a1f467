package lightning.cli;

import java.io.IOException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.work.DedicatedThread;

/** Writes pictures beside the work on the next ones. What is begun is written to its end; the first failure is told at the end. */
final class PictureWriteQueue implements AutoCloseable {
    private final ExecutorService threads;
    /** Each picture that waits keeps its film. */
    private final Semaphore permits;
    private final AtomicReference<Exception> problem = new AtomicReference<>();

    /** A picture on its way to its file. */
    @FunctionalInterface
    interface WriteTask {
        void write() throws IOException;
    }

    PictureWriteQueue(int count) {
        threads = Executors.newFixedThreadPool(count, DedicatedThread.factory("lightning-pictures"));
        permits = new Semaphore(2 * count);
    }

    /** Writes a picture soon; waits while too many are waiting. */
    void write(WriteTask picture) {
        permits.acquireUninterruptibly();
        threads.execute(() -> {
            try {
                if (problem.get() == null) {
                    picture.write();
                }
            } catch (IOException | RuntimeException e) {
                problem.compareAndSet(null, e);
            } finally {
                permits.release();
            }
        });
    }

    boolean hasFailed() {
        return problem.get() != null;
    }

    /** Waits until all are written. */
    void finish() throws Exception {
        close();
        if (hasFailed()) {
            throw problem.get();
        }
    }

    @Override
    public void close() {
        threads.shutdown();
        boolean interrupted = Thread.interrupted();
        boolean ended = false;
        while (!ended) {
            try {
                ended = threads.awaitTermination(1, TimeUnit.HOURS);
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
