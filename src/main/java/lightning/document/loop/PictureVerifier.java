package lightning.document.loop;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.image.Film;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.warmup.EditRehearsal;
import lightning.render.warmup.WarmUp;
import org.jspecify.annotations.Nullable;

/**
 * Verifies images with full traces on its own thread. When the editor is idle, it also warms up the process, edits first, and measures what an update
 * saves. A new verification replaces an older one. Thread-safe.
 */
final class PictureVerifier implements AutoCloseable {
    private static final int CLOSE_TIMEOUT_SECONDS = 10;
    /** Maximum time of own work for a saving's times to converge, in milliseconds of idle time. */
    private static final double MAX_WARM_UP_MS = 20_000;
    /** Idle time before background work starts; also its polling interval. */
    private static final long IDLE_DELAY_NS = 150_000_000;
    private static final long POLL_INTERVAL_NS = 5_000_000;

    private final WorkerPool workers;
    private final RenderListener listener;
    private final ExecutorService verifyThread = DedicatedThread.sequentialExecutor("lightning-verify");
    private final ExecutorService idleThread = DedicatedThread.lowPriorityExecutor("lightning-rest");
    private RenderQueue.@Nullable CancelSignal verifySignal;
    private RenderQueue.@Nullable CancelSignal idleSignal;
    /** Edit whose saving is to be measured; null if none. */
    private WarmSaving.@Nullable RepeatableEdit pendingEdit;
    private int runningCount;
    /** True once edits of the document's first picture were repeated. */
    private volatile boolean hasRehearsed;

    PictureVerifier(int threads, RenderListener listener) {
        this.listener = listener;
        workers = new WorkerPool(threads);
    }

    /**
     * Starts a verification. Does nothing once closed.
     *
     * @param request also stops it if it was canceled before this method returns
     */
    synchronized void verify(AccuracyGuarantee promise, Film picture, RenderQueue.CancelSignal request) {
        cancel();
        if (verifyThread.isShutdown()) {
            return;
        }
        var signal = new RenderQueue.CancelSignal(listener::verificationProgress);
        verifySignal = signal;
        if (request.isCanceled()) {
            cancel();
        }
        runningCount++;
        stopIdleWork();
        verifyThread.execute(() -> run(promise, picture, signal));
    }

    /** Begins with another document. */
    void openDocument() {
        hasRehearsed = false;
    }

    /** Sets the last edit and cancels the measurement of an older one. */
    synchronized void setLastEdit(Optional<WarmSaving.RepeatableEdit> edit) {
        stopIdleWork();
        pendingEdit = edit.orElse(null);
    }

    /**
     * While the editor is idle, warms up the process and measures the saving of the last update, unless it is known or being measured.
     * Reports it to the listener.
     *
     * @param picture finished picture, exact
     * @param options options that it was rendered with
     * @param first   work that precedes all other
     */
    synchronized void startIdleWork(PixelCache picture, RenderOptions options, Consumer<Progress> first) {
        boolean rehearses = !hasRehearsed && pendingEdit == null;
        if (pendingEdit == null && !rehearses && Engines.isFastestInUse() || idleSignal != null || verifyThread.isShutdown()) {
            return;
        }
        var signal = new RenderQueue.CancelSignal((_, _) -> {});
        WarmSaving.RepeatableEdit edit = pendingEdit;
        idleSignal = signal;
        idleThread.execute(() -> {
            // Workers inherit the priority of the thread that creates them, so this pool is not shared.
            try (WorkerPool lowPriorityWorkers = new WorkerPool(workers.count())) {
                waitForDisplay(signal);
                first.accept(signal);
                if (rehearses) {
                    EditRehearsal.run(picture, options, signal);
                    hasRehearsed = true;
                }
                WarmUp.run(picture.scene(), picture.geometry(), signal);
                finishMeasuring(signal,
                        edit == null ? Optional.empty() : WarmSaving.measure(edit, lowPriorityWorkers, MAX_WARM_UP_MS, signal));
            } catch (CancellationException e) {
                // Retried at the next idle time.
            } catch (RuntimeException | OutOfMemoryError e) {
                // Without a full trace there is no time to compare with.
                hasRehearsed = true;
                finishMeasuring(signal, Optional.empty());
            }
        });
    }

    /** Waits until the last edit and its thumbnails are displayed. */
    private static void waitForDisplay(RenderQueue.CancelSignal signal) {
        for (long end = System.nanoTime() + IDLE_DELAY_NS; System.nanoTime() < end && !signal.isCanceled();) {
            LockSupport.parkNanos(POLL_INTERVAL_NS);
        }
    }

    /** Cancels idle work. Other work would distort its timing. */
    synchronized void stopIdleWork() {
        if (idleSignal != null) {
            idleSignal.cancel();
            idleSignal = null;
        }
    }

    private void run(AccuracyGuarantee promise, Film picture, RenderQueue.CancelSignal signal) {
        Runnable outcome;
        try {
            Verification verification = promise.verify(picture, workers, signal);
            outcome = () -> listener.verified(verification);
        } catch (CancellationException e) {
            outcome = listener::canceled;
        } catch (Throwable e) {
            // Reports any failure; the window stays open.
            outcome = () -> listener.failed(e);
        }
        decrementRunning();
        outcome.run();
    }

    private synchronized void finishMeasuring(RenderQueue.CancelSignal signal, Optional<WarmSaving> saving) {
        if (idleSignal == signal) {
            idleSignal = null;
            pendingEdit = null;
            saving.ifPresent(listener::savingMeasured);
        }
    }

    private synchronized void decrementRunning() {
        runningCount--;
    }

    /** Returns whether a verification is running or pending. */
    synchronized boolean isBusy() {
        return runningCount > 0;
    }

    synchronized void cancel() {
        if (verifySignal != null) {
            verifySignal.cancel();
        }
    }

    private synchronized void shutdown() {
        stopIdleWork();
        cancel();
        verifyThread.shutdown();
        idleThread.shutdown();
    }

    @Override
    public void close() {
        shutdown();
        try {
            // The workers must outlive the trace that uses them.
            verifyThread.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
            idleThread.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        workers.close();
    }
}
