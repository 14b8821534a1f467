package lightning.bench.accuracy;

/**
 * What keeping a picture costs, beside a full trace that keeps nothing.
 *
 * @param first       milliseconds of the first pass
 * @param full        milliseconds of the full trace
 * @param fullRays    rays of the full trace
 * @param rows        hit rows kept
 * @param bytes       bytes kept, the film left out
 * @param bandwidthMs milliseconds that memory needs to write those bytes
 * @param isWarm        whether Java's compilers rested while it was timed: else its times say little
 */
public record FirstPassCost(Timing first, Timing full, long fullRays, long rows, long bytes, double bandwidthMs,
        boolean isWarm) {
    /** By how many percent the first pass is slower. */
    public double percentSlower() {
        return 100 * (first.median() / full.median() - 1);
    }

    /** By how many percent it would be slower if only memory set the limit. */
    public double percentAtMemoryLimit() {
        return 100 * bandwidthMs / full.median();
    }

    public double bytesPerRow() {
        return (double) bytes / Math.max(rows, 1);
    }
}
