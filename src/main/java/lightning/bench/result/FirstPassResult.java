package lightning.bench.result;

import lightning.bench.accuracy.FirstPassCost;

/**
 * Cost of the first pass, compared with a traditional trace without a cache.
 *
 * @param time          time of the first pass
 * @param fullTrace     time of the traditional trace, measured in turns with it
 * @param percentSlower added time of the first pass, percent
 * @param fullRays      rays of the full trace
 * @param rows          cached rows, reflections included
 * @param bytes         bytes of the cache, without the film
 * @param editsToPayOff number of edits with mean saving until break-even; NaN if edits save nothing
 */
public record FirstPassResult(TimeSamples time, TimeSamples fullTrace, double percentSlower, long fullRays, long rows, long bytes,
        double bytesPerRow,
        double bytesPerPixel, double editsToPayOff) {

    /** @param savedMs milliseconds that an edit saves, the average of all */
    public static FirstPassResult of(FirstPassCost cost, long pixels, double savedMs) {
        double extraMs = Math.max(0, cost.first().median() - cost.full().median());
        return new FirstPassResult(TimeSamples.of(cost.first()), TimeSamples.of(cost.full()), cost.percentSlower(), cost.fullRays(),
                cost.rows(),
                cost.bytes(),
                cost.bytesPerRow(), (double) cost.bytes() / pixels, savedMs > 0 ? Math.ceil(extraMs / savedMs) : Double.NaN);
    }
}
