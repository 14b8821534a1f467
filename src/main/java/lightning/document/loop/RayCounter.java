package lightning.document.loop;

import java.util.function.LongSupplier;

/** Counts the rays of one stage of an image on all threads. Thread-safe. */
final class RayCounter {
    private final LongSupplier clock;
    private RenderActivity.Stage stage = RenderActivity.Stage.CENTERS;
    private long startNs;
    /** Time of the first report; its rays were cast before. */
    private long firstNs;
    private long lastNs;
    private long rays;
    private boolean hasRays;

    /** @param clock time in nanoseconds */
    RayCounter(LongSupplier clock) {
        this.clock = clock;
        startNs = clock.getAsLong();
    }

    synchronized void start(RenderActivity.Stage next) {
        stage = next;
        startNs = clock.getAsLong();
        rays = 0;
        hasRays = false;
        firstNs = 0;
        lastNs = 0;
    }

    synchronized void add(long count) {
        lastNs = clock.getAsLong();
        if (hasRays) {
            rays += count;
        } else {
            hasRays = true;
            firstNs = lastNs;
        }
    }

    synchronized RenderActivity activity() {
        return new RenderActivity(stage, rays, clock.getAsLong() - startNs, lastNs - firstNs);
    }
}
