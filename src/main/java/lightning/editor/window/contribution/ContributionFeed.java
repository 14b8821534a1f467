package lightning.editor.window.contribution;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.OwnThread;
import lightning.base.work.Progress;

/**
 * Answers questions about the picture on a thread of its own, which exists from the first question until the pane closes; a newer question
 * stops an older. Belongs to the window's thread.
 */
final class ContributionFeed implements AutoCloseable {
    private final Executor window;
    private final String name;
    /** Null while the pane is closed. */
    private ExecutorService thread;
    private final AtomicReference<Object> newest = new AtomicReference<>();

    /**
     * @param window runs tasks in turn on the window's thread
     * @param name   of the thread
     */
    ContributionFeed(Executor window, String name) {
        this.window = window;
        this.name = name;
    }

    /**
     * Asks.
     *
     * @param answer stops where its progress asks for it; empty where there is none
     * @param heard  on the window's thread, unless a newer question came
     * @param failed likewise, where it failed
     */
    <T> void ask(Function<Progress, Optional<T>> answer, Consumer<T> heard, Consumer<Throwable> failed) {
        var own = new Object();
        newest.set(own);
        Progress progress = Progress.until(() -> newest.get() != own);
        if (thread == null) {
            thread = OwnThread.inTurn(name);
        }
        thread.execute(() -> {
            if (progress.isCancelled()) {
                return;
            }
            try {
                answer.apply(progress).ifPresent(result -> tell(own, () -> heard.accept(result)));
            } catch (CancellationException e) {
                // A newer question is asked.
            } catch (RuntimeException | OutOfMemoryError e) {
                tell(own, () -> failed.accept(e));
            }
        });
    }

    private void tell(Object own, Runnable what) {
        window.execute(() -> {
            if (newest.get() == own) {
                what.run();
            }
        });
    }

    /** Stops what is being asked. */
    void stop() {
        newest.set(new Object());
    }

    /** Stops what is being asked and ends the thread; a later question starts another. */
    @Override
    public void close() {
        stop();
        if (thread != null) {
            thread.shutdown();
            thread = null;
        }
    }
}
