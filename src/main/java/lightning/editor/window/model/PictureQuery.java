package lightning.editor.window.model;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import org.jspecify.annotations.Nullable;

/**
 * Runs queries about the picture on a thread of its own, which exists from the first query until the pane closes. A new query cancels the
 * previous one. Confined to the window's thread.
 */
public final class PictureQuery implements AutoCloseable {
    private final Executor windowExecutor;
    private final String name;
    /** Null while the pane is closed. */
    private @Nullable ExecutorService thread;
    private final AtomicReference<Object> latest = new AtomicReference<>();

    /**
     * Creates an instance without a thread.
     *
     * @param windowExecutor runs tasks in order on the window's thread
     * @param name name of the thread
     */
    public PictureQuery(Executor windowExecutor, String name) {
        this.windowExecutor = windowExecutor;
        this.name = name;
    }

    /**
     * Starts a query.
     *
     * @param query stops when its progress requests it; empty if there is no result
     * @param onResult receives the result on the window's thread, unless a newer query was started
     * @param onFailure receives a failure on the window's thread, unless a newer query was started
     */
    public <T> void submit(Function<Progress, Optional<T>> query, Consumer<T> onResult, Consumer<Throwable> onFailure) {
        var token = new Object();
        latest.set(token);
        Progress progress = Progress.cancellation(() -> latest.get() != token);
        if (thread == null) {
            thread = DedicatedThread.sequentialExecutor(name);
        }
        thread.execute(() -> {
            if (progress.isCanceled()) {
                return;
            }
            try {
                query.apply(progress).ifPresent(result -> deliver(token, () -> onResult.accept(result)));
            } catch (CancellationException e) {
                // A newer query is running.
            } catch (RuntimeException | OutOfMemoryError e) {
                deliver(token, () -> onFailure.accept(e));
            }
        });
    }

    private void deliver(Object token, Runnable action) {
        windowExecutor.execute(() -> {
            if (latest.get() == token) {
                action.run();
            }
        });
    }

    /** Cancels the current query. */
    public void cancel() {
        latest.set(new Object());
    }

    /** Cancels the current query and ends the thread; a later query starts another. */
    @Override
    public void close() {
        cancel();
        if (thread != null) {
            thread.shutdown();
            thread = null;
        }
    }
}
