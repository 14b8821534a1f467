package lightning.bench;

import lightning.bench.accuracy.FirstPassCost;

/**
 * What the first pass costs, beside the traditional trace that keeps nothing.
 *
 * @param time          of the first pass
 * @param fullTrace     of the traditional trace, measured in turns with it
 * @param percentSlower by how much the first pass is slower
 * @param fullRays      rays of the full trace
 * @param rows          hit rows kept, mirror images included
 * @param bytes         kept, the film left out
 * @param editsToPayOff after how many edits of average saving the first pass has paid for itself; NaN where edits save nothing
 */
public record FirstPassResult(TimeSamples time, TimeSamples fullTrace, double percentSlower, long fullRays, long rows, long bytes,
        double bytesPerRow,
        double bytesPerPixel, double editsToPayOff) {

    /** @param savedMs milliseconds that an edit saves, the average of all */
    static FirstPassResult of(FirstPassCost cost, long pixels, double savedMs) {
        double extraMs = Math.max(0, cost.first().median() - cost.full().median());
        return new FirstPassResult(TimeSamples.of(cost.first()), TimeSamples.of(cost.full()), cost.percentSlower(), cost.fullRays(),
                cost.rows(),
                cost.bytes(),
                cost.bytesPerRow(), (double) cost.bytes() / pixels, savedMs > 0 ? Math.ceil(extraMs / savedMs) : Double.NaN);
    }
}
