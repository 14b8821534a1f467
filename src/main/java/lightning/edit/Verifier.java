package lightning.edit;

import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import lightning.shading.Workers;

/** Traces in full on a thread of its own; a newer verification replaces an older one. Safe for several threads. */
final class Verifier implements AutoCloseable {
    private static final int PATIENCE_SECONDS = 10;

    private final Workers workers;
    private final RenderListener listener;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
        Thread t = new Thread(task, "lightning-verify");
        t.setDaemon(true);
        return t;
    });
    private RenderQueue.Stop stop;
    private double fullTraceMs = Double.NaN;
    private int pictures;
    private int running;

    Verifier(int threads, RenderListener listener) {
        this.listener = listener;
        workers = new Workers(threads);
    }

    synchronized void verify(Verification.Request request) {
        cancel();
        var own = new RenderQueue.Stop(listener::verifying);
        int picture = pictures;
        stop = own;
        running++;
        thread.execute(() -> run(request, own, picture));
    }

    private void run(Verification.Request request, RenderQueue.Stop own, int picture) {
        Runnable outcome;
        try {
            Verification verification = request.run(workers, own);
            outcome = () -> listener.verified(verification);
            measured(picture, verification.fullTraceMs());
        } catch (CancellationException e) {
            outcome = listener::cancelled;
        } catch (Throwable e) {
            // Whatever it is, the window lives on and says so.
            outcome = () -> listener.failed(e);
        }
        ended();
        outcome.run();
    }

    private synchronized void measured(int picture, double milliseconds) {
        if (picture == pictures) {
            fullTraceMs = milliseconds;
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

    /** The measured time of a full trace, milliseconds; empty if none was verified of this picture. */
    synchronized OptionalDouble fullTraceMs() {
        return Double.isNaN(fullTraceMs) ? OptionalDouble.empty() : OptionalDouble.of(fullTraceMs);
    }

    /** Another picture takes another time. */
    synchronized void forgetTime() {
        pictures++;
        fullTraceMs = Double.NaN;
    }

    @Override
    public void close() {
        cancel();
        thread.shutdown();
        try {
            // The workers must not end before the trace that waits for them.
            thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        workers.close();
    }
}
