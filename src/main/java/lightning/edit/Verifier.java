package lightning.edit;

import java.util.Collections;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import lightning.accuracy.FullTraceTime;
import lightning.accuracy.Promise;
import lightning.accuracy.Verification;
import lightning.image.Film;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.shading.Workers;
import lightning.trace.Geometry;

/**
 * Traces in full on a thread of its own, to verify a picture and to find out how long that takes; a newer verification
 * replaces an older one. Safe for several threads.
 */
final class Verifier implements AutoCloseable {
    private static final int PATIENCE_SECONDS = 10;
    /** So often a full trace is measured, each time after other work: Java may have become faster. */
    private static final int TIMES = 3;

    /** What decides how long a full trace of one picture takes, but for where its lights are. */
    private record Effort(int depth, Sampling sampling, long lights) {
        static Effort of(Scene scene) {
            Sampling sampling = scene.picture().sampling();
            return new Effort(scene.picture().depth(), sampling.isFine() ? sampling : Sampling.DEFAULT,
                    scene.lights().stream().filter(scene::shines).count());
        }
    }

    private final Workers workers;
    private final RenderListener listener;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
        Thread t = new Thread(task, "lightning-verify");
        t.setDaemon(true);
        return t;
    });
    private RenderQueue.Stop stop;
    private RenderQueue.Stop measuring;
    private Effort known;
    private double shortest;
    private int measured;
    private int pictures;
    private int running;

    Verifier(int threads, RenderListener listener) {
        this.listener = listener;
        workers = new Workers(threads);
    }

    /**
     * Begins a verification; nothing once closed.
     *
     * @param geometry the picture's, which only measuring gets for free
     * @param asked    stops it too when it was asked for before this returns
     */
    synchronized void verify(Promise promise, Film picture, Geometry geometry, RenderQueue.Stop asked) {
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
        measure(promise.sight().scene(), geometry);
    }

    /** Finds out what a warm full trace takes, unless it is known well or being found out; the listener hears of it. */
    synchronized void measure(Scene scene, Geometry geometry) {
        Effort effort = Effort.of(scene);
        if (effort.equals(known) && measured >= TIMES || measuring != null || thread.isShutdown()) {
            return;
        }
        var own = new RenderQueue.Stop((_, _) -> { });
        int picture = pictures;
        measuring = own;
        thread.execute(() -> {
            try {
                measured(picture, effort, Collections.min(FullTraceTime.measure(scene, geometry, workers, own).milliseconds()));
            } catch (CancellationException e) {
                // It is measured when there is time again.
            } catch (RuntimeException | OutOfMemoryError e) {
                // A picture that cannot be traced in full has no time that savings could be savings of.
                forget(own);
            }
        });
    }

    /** There is other work: what is measured beside it would be too long. */
    synchronized void pause() {
        if (measuring != null) {
            measuring.ask();
            measuring = null;
        }
    }

    private synchronized void forget(RenderQueue.Stop own) {
        measuring = measuring == own ? null : measuring;
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

    private synchronized void measured(int picture, Effort effort, double milliseconds) {
        if (picture == pictures) {
            // What slowed one measurement down would make savings look larger than they are.
            shortest = effort.equals(known) ? Math.min(shortest, milliseconds) : milliseconds;
            measured = effort.equals(known) ? measured + 1 : 1;
            known = effort;
            measuring = null;
            listener.measured(shortest);
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

    /** Another picture takes another time. */
    synchronized void forgetTime() {
        pictures++;
        known = null;
        pause();
    }

    private synchronized void shutdown() {
        pause();
        cancel();
        thread.shutdown();
    }

    @Override
    public void close() {
        shutdown();
        try {
            // The workers must not end before the trace that waits for them.
            thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        workers.close();
    }
}
