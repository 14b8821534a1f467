package lightning.render.warmup;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import lightning.base.work.DedicatedThread;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.mesh.MeshTestsWarmUp;

/**
 * Lanes for a long render: the tests of single rays as soon as a thread of its own has compiled them, which takes about two seconds, and much later the
 * lane engine, for the remaining tiles, which compile it. The first costs a second of one processor.
 * <pre>{@code try (var lanes = new DelayedLanes()) { renderer.render(scene, progress); } }</pre>
 */
public final class DelayedLanes implements AutoCloseable {
    /**
     * Compiling the lanes takes about 35 s of two busy processors, and then they save 40 % of the time. So a render gains if it lasts 90 s more,
     * which is likely for one that has lasted as long.
     */
    private static final long DELAY_SECONDS = 90;

    private final CountDownLatch closed = new CountDownLatch(1);

    public DelayedLanes() {
        this(TimeUnit.SECONDS.toMillis(DELAY_SECONDS));
    }

    DelayedLanes(long delayMilliseconds) {
        DedicatedThread.create("lightning-lanes", () -> switchAfter(delayMilliseconds)).start();
    }

    private void switchAfter(long milliseconds) {
        try {
            if (Engines.hasLanes()) {
                MeshTestsWarmUp.run(() -> closed.getCount() == 0);
            }
            if (!closed.await(milliseconds, TimeUnit.MILLISECONDS)) {
                Engines.use(Engines.FASTEST);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        closed.countDown();
    }
}
