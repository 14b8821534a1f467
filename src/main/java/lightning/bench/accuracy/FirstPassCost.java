package lightning.bench.accuracy;

import lightning.render.measure.Timing;

/**
 * Cost of building the cache in the first pass, compared with a full trace without a cache.
 *
 * @param first       milliseconds of the first pass
 * @param full        milliseconds of the full trace
 * @param fullRays    rays of the full trace
 * @param rows        cached rows
 * @param bytes       bytes of the cache, without the film
 * @param bandwidthMs minimum milliseconds to write those bytes to memory
 * @param isWarm      whether the JIT compilers were idle; otherwise its times are unreliable
 */
public record FirstPassCost(Timing first, Timing full, long fullRays, long rows, long bytes, double bandwidthMs,
        boolean isWarm) {
    /** Returns the added time of the first pass, percent. */
    public double percentSlower() {
        return 100 * (first.median() / full.median() - 1);
    }

    /** Returns the added time if only memory bandwidth limited the first pass, percent. */
    public double percentAtMemoryLimit() {
        return 100 * bandwidthMs / full.median();
    }

    public double bytesPerRow() {
        return (double) bytes / Math.max(rows, 1);
    }
}
