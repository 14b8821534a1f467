package lightning.accuracy;

/**
 * What keeping a picture costs, beside a full trace that keeps nothing.
 *
 * @param firstMs     milliseconds of the first pass, median
 * @param fullMs      milliseconds of the full trace, median
 * @param rows        hit rows kept
 * @param bytes       bytes kept, the film left out
 * @param bandwidthMs milliseconds that memory needs to write those bytes
 */
public record FirstPassCost(double firstMs, double fullMs, long rows, long bytes, double bandwidthMs) {
    /** By how many percent the first pass is slower. */
    public double percentSlower() {
        return 100 * (firstMs / fullMs - 1);
    }

    /** By how many percent it would be slower if only memory set the limit. */
    public double percentFloor() {
        return 100 * bandwidthMs / fullMs;
    }

    public double bytesPerRow() {
        return (double) bytes / Math.max(rows, 1);
    }
}
