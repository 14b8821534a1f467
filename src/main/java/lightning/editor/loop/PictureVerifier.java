package lightning.editor.loop;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import lightning.base.work.DedicatedThread;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.AccuracyGuarantee;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.render.engine.choice.Engines;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.render.warmup.WarmUp;
import lightning.scene.Scene;

/**
 * Traces in full on a thread of its own, to verify a picture, and where nobody works to warm the process up and to find out what
 * an update saves; a newer verification replaces an older one. Safe for several threads.
 */
final class PictureVerifier implements AutoCloseable {
    private static final int CLOSE_TIMEOUT_SECONDS = 10;
    /** How long a saving's times may take to come to rest, milliseconds of own work, while nobody works. */
    private static final double MAX_WARM_UP_MS = 20_000;
    /** Nobody works who did nothing for so long; how often that is looked at. */
    private static final long IDLE_DELAY_NS = 150_000_000;
    private static final long POLL_INTERVAL_NS = 5_000_000;

    private final WorkerPool workers;
    private final RenderListener listener;
    private final ExecutorService verifyThread = DedicatedThread.sequentialExecutor("lightning-verify");
    private final ExecutorService idleThread = DedicatedThread.lowPriorityExecutor("lightning-rest");
    private RenderQueue.CancelSignal verifySignal;
    private RenderQueue.CancelSignal idleSignal;
    /** What a saving is to be measured of; null where there is nothing. */
    private WarmSaving.RepeatableEdit pendingEdit;
    private int runningCount;

    PictureVerifier(int threads, RenderListener listener) {
        this.listener = listener;
        workers = new WorkerPool(threads);
    }

    /**
     * Begins a verification; nothing once closed.
     *
     * @param request stops it too when it was asked for before this returns
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

    /** What was done last; a saving that is still being measured is of no use any more. */
    synchronized void setLastEdit(Optional<WarmSaving.RepeatableEdit> edit) {
        stopIdleWork();
        pendingEdit = edit.orElse(null);
    }

    /**
     * While nobody works: warms the process up, and finds out what the update made last saves, unless that is known or being
     * found out; the listener hears of it.
     *
     * @param scene    what the picture shows
     * @param geometry serves it
     */
    synchronized void startIdleWork(Scene scene, Geometry geometry) {
        if (pendingEdit == null && Engines.isFastestInUse() || idleSignal != null || verifyThread.isShutdown()) {
            return;
        }
        var signal = new RenderQueue.CancelSignal((_, _) -> {});
        WarmSaving.RepeatableEdit edit = pendingEdit;
        idleSignal = signal;
        idleThread.execute(() -> {
            // Theirs is the rank of the thread that makes them, so that these are no other's.
            try (WorkerPool lowPriorityWorkers = new WorkerPool(workers.count())) {
                waitForDisplay(signal);
                WarmUp.run(scene, geometry, signal);
                finishMeasuring(signal,
                        edit == null ? Optional.empty() : WarmSaving.measure(edit, lowPriorityWorkers, MAX_WARM_UP_MS, signal));
            } catch (CancellationException e) {
                // It is done when there is time again.
            } catch (RuntimeException | OutOfMemoryError e) {
                // A picture that cannot be traced in full has no time that savings could be savings of.
                finishMeasuring(signal, Optional.empty());
            }
        });
    }

    /** What was done last comes to the screen first, and into small pictures of it. */
    private static void waitForDisplay(RenderQueue.CancelSignal signal) {
        for (long end = System.nanoTime() + IDLE_DELAY_NS; System.nanoTime() < end && !signal.isCanceled();) {
            LockSupport.parkNanos(POLL_INTERVAL_NS);
        }
    }

    /** There is other work: what is measured beside it would be too long. */
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
            // Whatever it is, the window lives on and says so.
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

    /** Whether a verification runs or waits. */
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
            // The workers must not end before the trace that waits for them.
            verifyThread.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
            idleThread.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        workers.close();
    }
}
