package lightning.editor.window.model;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import lightning.base.work.DedicatedThread;
import org.jspecify.annotations.Nullable;

/**
 * Computes a pane's content on a dedicated thread, which exists from the first request until the pane closes. Coalesces requests: only the
 * newest is computed. Belongs to the window's thread.
 */
public final class PaneUpdater<T> implements AutoCloseable {
    private final String name;
    private final Executor window;
    private final Supplier<Optional<T>> compute;
    private final Consumer<T> show;
    /** Null while the pane is closed. */
    private @Nullable ThreadRun run;

    /** Lifetime of the thread, from the first request until the pane closes. */
    private record ThreadRun(ExecutorService thread, AtomicBoolean requested) {}

    /**
     * @param name  name of the thread
     * @param window  runs tasks in order on the window's thread
     * @param compute  computes the value on the thread; empty if there is nothing to show
     * @param show  shows the value on the window's thread, unless the pane was closed
     */
    public PaneUpdater(String name, Executor window, Supplier<Optional<T>> compute, Consumer<T> show) {
        this.name = name;
        this.window = window;
        this.compute = compute;
        this.show = show;
    }

    /** Requests that the value is computed again and shown. */
    public void request() {
        if (run == null) {
            run = new ThreadRun(DedicatedThread.sequentialExecutor(name), new AtomicBoolean());
        }
        ThreadRun current = run;
        if (current.requested.compareAndSet(false, true)) {
            current.thread.execute(() -> computeAndShow(current));
        }
    }

    private void computeAndShow(ThreadRun request) {
        request.requested.set(false);
        compute.get().ifPresent(value -> window.execute(() -> {
            if (request == run) {
                show.accept(value);
            }
        }));
    }

    /** Stops the thread and drops its pending result. A later request starts a new thread. */
    @Override
    public void close() {
        if (run != null) {
            run.thread.shutdown();
            run = null;
        }
    }
}
