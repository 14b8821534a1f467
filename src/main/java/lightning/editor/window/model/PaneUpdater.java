package lightning.editor.window.model;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import lightning.base.work.DedicatedThread;

/**
 * Computes what a pane shows on a thread of its own, which exists from the first request until the pane closes. Of requests that come
 * faster than they are answered, only the newest is answered. Belongs to the window's thread.
 */
public final class PaneUpdater<T> implements AutoCloseable {
    private final String name;
    private final Executor window;
    private final Supplier<Optional<T>> compute;
    private final Consumer<T> show;
    /** Null while the pane is closed. */
    private ThreadRun run;

    /** From a first request until the pane closes. */
    private record ThreadRun(ExecutorService thread, AtomicBoolean requested) {}

    /**
     * @param name    of the thread
     * @param window  runs tasks in turn on the window's thread
     * @param compute runs on the thread; empty where there is nothing to show
     * @param show    runs on the window's thread, unless the pane closed
     */
    public PaneUpdater(String name, Executor window, Supplier<Optional<T>> compute, Consumer<T> show) {
        this.name = name;
        this.window = window;
        this.compute = compute;
        this.show = show;
    }

    /** Computes and shows the value again. */
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

    /** Ends the thread; what it computes is not shown. A later request starts another. */
    @Override
    public void close() {
        if (run != null) {
            run.thread.shutdown();
            run = null;
        }
    }
}
