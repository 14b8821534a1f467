package lightning.render.warmup;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Background warm-up of the lane engine during a long render, for its remaining tiles. Has no cost for short renders.
 * <pre>{@code try (var warm = new DelayedWarmUp(scene)) { renderer.render(scene, progress); } }</pre>
 */
public final class DelayedWarmUp implements AutoCloseable {
    /** Compiling the lanes takes about as long; a render that ends soon after would not benefit. */
    private static final long DELAY_SECONDS = 10;

    private final CountDownLatch closed = new CountDownLatch(1);

    public DelayedWarmUp(Scene scene) {
        Thread thread = DedicatedThread.create("lightning-warm-up", () -> runAfterDelay(scene));
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    private void runAfterDelay(Scene scene) {
        try {
            if (!closed.await(DELAY_SECONDS, TimeUnit.SECONDS)) {
                WarmUp.run(scene, Geometry.of(scene), untilClosed());
            }
        } catch (CancellationException e) {
            // The render ended first.
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (OutOfMemoryError e) {
            // Ignored: the render needs the memory, and completes without the warm-up.
        }
    }

    private Progress untilClosed() {
        return Progress.cancellation(() -> closed.getCount() == 0);
    }

    @Override
    public void close() {
        closed.countDown();
    }
}
