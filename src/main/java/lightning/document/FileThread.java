package lightning.document;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import org.jspecify.annotations.Nullable;

/**
 * Background file access, so that no disk blocks the window's thread. Delivers results on the window's thread. Runs writes in order and
 * finishes them when closed.
 */
public final class FileThread implements Executor, AutoCloseable {
    private static final int CLOSE_TIMEOUT_SECONDS = 60;

    private final Executor windowExecutor;
    private final ExecutorService thread = DedicatedThread.sequentialExecutor("lightning-files");

    /** @param window runs tasks in order on the window's thread */
    public FileThread(Executor window) {
        this.windowExecutor = window;
    }

    /** Task that reads or writes files. */
    public interface FileTask<T> {
        @Nullable
        T run() throws Exception;
    }

    /** Returns the executor that runs tasks in order on the window's thread. */
    public Executor windowExecutor() {
        return windowExecutor;
    }

    /** Runs a task after all earlier ones, without reporting its result. */
    @Override
    public void execute(Runnable task) {
        thread.execute(task);
    }

    /**
     * Runs a task after all earlier ones.
     *
     * @param done   receives the result on the window's thread
     * @param failed receives a failure there
     */
    public <T> void runInOrder(FileTask<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        thread.execute(task(task, done, failed));
    }

    /** Runs a task on its own thread, for reads that may take long and need no order. */
    public <T> void runConcurrently(FileTask<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        DedicatedThread.create("lightning-reading", task(task, done, failed)).start();
    }

    private <T> Runnable task(FileTask<T> fileTask, Consumer<T> done, Consumer<Throwable> failed) {
        return () -> {
            try {
                T result = fileTask.run();
                windowExecutor.execute(() -> done.accept(result));
            } catch (Exception | OutOfMemoryError e) {
                windowExecutor.execute(() -> failed.accept(e));
            }
        };
    }

    /** Finishes all requested tasks. */
    @Override
    public void close() {
        thread.shutdown();
        try {
            thread.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
