package lightning.editor.document;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.work.OwnThread;

/**
 * Reads and writes files beside the window's thread, so that no disk holds up a window, and brings there what came of it.
 * What is written is written in turn; closing waits for it.
 */
public final class FileThread implements Executor, AutoCloseable {
    private static final int PATIENCE_SECONDS = 60;

    private final Executor window;
    private final ExecutorService thread = OwnThread.inTurn("lightning-files");

    /** @param window runs tasks in turn on the window's thread */
    public FileThread(Executor window) {
        this.window = window;
    }

    /** Something with files. */
    public interface Work<T> {
        T run() throws Exception;
    }

    /** Runs tasks in turn on the window's thread. */
    public Executor window() {
        return window;
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
    public <T> void inTurn(Work<T> work, Consumer<T> done, Consumer<Throwable> failed) {
        thread.execute(task(work, done, failed));
    }

    /** The same on a thread of its own: reading, which may take long and waits for nothing. */
    public <T> void beside(Work<T> work, Consumer<T> done, Consumer<Throwable> failed) {
        OwnThread.of("lightning-reading", task(work, done, failed)).start();
    }

    private <T> Runnable task(Work<T> work, Consumer<T> done, Consumer<Throwable> failed) {
        return () -> {
            try {
                T result = work.run();
                window.execute(() -> done.accept(result));
            } catch (Exception | OutOfMemoryError e) {
                window.execute(() -> failed.accept(e));
            }
        };
    }

    /** Finishes what was asked. */
    @Override
    public void close() {
        thread.shutdown();
        try {
            thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
