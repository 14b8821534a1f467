package lightning.editor.loop;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import lightning.base.work.OwnThread;
import lightning.base.work.Workers;
import lightning.bench.accuracy.Promise;
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
final class Verifier implements AutoCloseable {
    private static final int PATIENCE_SECONDS = 10;
    /** How long a saving's times may take to come to rest, milliseconds of own work, while nobody works. */
    private static final double WARM_UP_MS = 20_000;
    /** Nobody works who did nothing for so long; how often that is looked at. */
    private static final long SEEN_NS = 150_000_000;
    private static final long LOOK_NS = 5_000_000;

    private final Workers workers;
    private final RenderListener listener;
    private final ExecutorService thread = OwnThread.inTurn("lightning-verify");
    private final ExecutorService resting = OwnThread.inTurnBehind("lightning-rest");
    private RenderQueue.Stop stop;
    private RenderQueue.Stop measuring;
    /** What a saving is to be measured of; null where there is nothing. */
    private WarmSaving.Edit waiting;
    private int running;

    Verifier(int threads, RenderListener listener) {
        this.listener = listener;
        workers = new Workers(threads);
    }

    /**
     * Begins a verification; nothing once closed.
     *
     * @param asked stops it too when it was asked for before this returns
     */
    synchronized void verify(Promise promise, Film picture, RenderQueue.Stop asked) {
        cancel();
        if (thread.isShutdown()) {
            return;
        }
        var own = new RenderQueue.Stop(listener::verifying);
        stop = own;
        if (asked.isCancelled()) {
            cancel();
        }
        running++;
        pause();
        thread.execute(() -> run(promise, picture, own));
    }

    /** What was done last; a saving that is still being measured is of no use any more. */
    synchronized void done(Optional<WarmSaving.Edit> edit) {
        pause();
        waiting = edit.orElse(null);
    }

    /**
     * While nobody works: warms the process up, and finds out what the update made last saves, unless that is known or being
     * found out; the listener hears of it.
     *
     * @param shown    what the picture shows
     * @param geometry serves it
     */
    synchronized void rest(Scene shown, Geometry geometry) {
        if (waiting == null && Engines.areFastest() || measuring != null || thread.isShutdown()) {
            return;
        }
        var own = new RenderQueue.Stop((_, _) -> {});
        WarmSaving.Edit edit = waiting;
        measuring = own;
        resting.execute(() -> {
            // Theirs is the rank of the thread that makes them, so that these are no other's.
            try (Workers behind = new Workers(workers.count())) {
                letSee(own);
                WarmUp.run(shown, geometry, own);
                measured(own, edit == null ? Optional.empty() : WarmSaving.measure(edit, behind, WARM_UP_MS, own));
            } catch (CancellationException e) {
                // It is done when there is time again.
            } catch (RuntimeException | OutOfMemoryError e) {
                // A picture that cannot be traced in full has no time that savings could be savings of.
                measured(own, Optional.empty());
            }
        });
    }

    /** What was done last comes to the screen first, and into small pictures of it. */
    private static void letSee(RenderQueue.Stop own) {
        for (long end = System.nanoTime() + SEEN_NS; System.nanoTime() < end && !own.isCancelled();) {
            LockSupport.parkNanos(LOOK_NS);
        }
    }

    /** There is other work: what is measured beside it would be too long. */
    synchronized void pause() {
        if (measuring != null) {
            measuring.ask();
            measuring = null;
        }
    }

    private void run(Promise promise, Film picture, RenderQueue.Stop own) {
        Runnable outcome;
        try {
            Verification verification = promise.verify(picture, workers, own);
            outcome = () -> listener.verified(verification);
        } catch (CancellationException e) {
            outcome = listener::cancelled;
        } catch (Throwable e) {
            // Whatever it is, the window lives on and says so.
            outcome = () -> listener.failed(e);
        }
        ended();
        outcome.run();
    }

    private synchronized void measured(RenderQueue.Stop own, Optional<WarmSaving> saving) {
        if (measuring == own) {
            measuring = null;
            waiting = null;
            saving.ifPresent(listener::measured);
        }
    }

    private synchronized void ended() {
        running--;
    }

    /** Whether a verification runs or waits. */
    synchronized boolean isBusy() {
        return running > 0;
    }

    synchronized void cancel() {
        if (stop != null) {
            stop.ask();
        }
    }

    private synchronized void shutdown() {
        pause();
        cancel();
        thread.shutdown();
        resting.shutdown();
    }

    @Override
    public void close() {
        shutdown();
        try {
            // The workers must not end before the trace that waits for them.
            thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS);
            resting.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        workers.close();
    }
}
