package lightning.cli.output;

import java.io.IOException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.work.DedicatedThread;

/** Writes images in the background. Started writes run to completion; {@link #finish} throws the first failure. */
public final class PictureWriteQueue implements AutoCloseable {
    private final ExecutorService threads;
    /** Limits the number of queued images, since each keeps its film. */
    private final Semaphore permits;
    private final AtomicReference<Exception> problem = new AtomicReference<>();

    /** Write of one image. */
    @FunctionalInterface
    public interface WriteTask {
        void write() throws IOException;
    }

    public PictureWriteQueue(int count) {
        threads = Executors.newFixedThreadPool(count, DedicatedThread.factory("lightning-pictures"));
        permits = new Semaphore(2 * count);
    }

    /** Queues an image; blocks while the queue is full. */
    public void write(WriteTask picture) {
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

    public boolean hasFailed() {
        return problem.get() != null;
    }

    /** Waits until all images are written. */
    public void finish() throws Exception {
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
