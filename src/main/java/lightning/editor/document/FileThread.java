package lightning.editor.document;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;

/**
 * Reads and writes files beside the window's thread, so that no disk holds up a window, and brings there what came of it.
 * What is written is written in turn; closing waits for it.
 */
public final class FileThread implements Executor, AutoCloseable {
    private static final int CLOSE_TIMEOUT_SECONDS = 60;

    private final Executor windowExecutor;
    private final ExecutorService thread = DedicatedThread.sequentialExecutor("lightning-files");

    /** @param window runs tasks in turn on the window's thread */
    public FileThread(Executor window) {
        this.windowExecutor = window;
    }

    /** Something with files. */
    public interface FileTask<T> {
        T run() throws Exception;
    }

    /** Runs tasks in turn on the window's thread. */
    public Executor windowExecutor() {
        return windowExecutor;
    }

    /** Does something after all that was asked before; nobody hears what comes of it. */
    @Override
    public void execute(Runnable task) {
        thread.execute(task);
    }

    /**
     * Does something after all that was asked before.
     *
     * @param done   hears on the window's thread what came of it
     * @param failed hears there why nothing did
     */
    public <T> void runInOrder(FileTask<T> task, Consumer<T> done, Consumer<Throwable> failed) {
        thread.execute(task(task, done, failed));
    }

    /** The same on a thread of its own: reading, which may take long and waits for nothing. */
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

    /** Finishes what was asked. */
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
