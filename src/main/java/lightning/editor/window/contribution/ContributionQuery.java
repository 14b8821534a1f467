package lightning.editor.window.contribution;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;

/**
 * Answers questions about the picture on a thread of its own, which exists from the first question until the pane closes; a newer question
 * stops an older. Belongs to the window's thread.
 */
final class ContributionQuery implements AutoCloseable {
    private final Executor windowExecutor;
    private final String name;
    /** Null while the pane is closed. */
    private ExecutorService thread;
    private final AtomicReference<Object> latest = new AtomicReference<>();

    /**
     * @param windowExecutor runs tasks in turn on the window's thread
     * @param name   of the thread
     */
    ContributionQuery(Executor windowExecutor, String name) {
        this.windowExecutor = windowExecutor;
        this.name = name;
    }

    /**
     * Asks.
     *
     * @param query stops where its progress asks for it; empty where there is none
     * @param onResult  on the window's thread, unless a newer question came
     * @param onFailure likewise, where it failed
     */
    <T> void submit(Function<Progress, Optional<T>> query, Consumer<T> onResult, Consumer<Throwable> onFailure) {
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
                // A newer question is asked.
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

    /** Stops what is being asked. */
    void cancel() {
        latest.set(new Object());
    }

    /** Stops what is being asked and ends the thread; a later question starts another. */
    @Override
    public void close() {
        cancel();
        if (thread != null) {
            thread.shutdown();
            thread = null;
        }
    }
}
