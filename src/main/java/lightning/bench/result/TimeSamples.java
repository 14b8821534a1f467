package lightning.bench.result;

import java.util.List;
import lightning.render.measure.Timing;

/**
 * Times of one task in milliseconds.
 *
 * @param median        median of all samples
 * @param lowerQuartile first quartile
 * @param upperQuartile third quartile
 * @param samples       samples in order of measurement
 */
public record TimeSamples(double median, double lowerQuartile, double upperQuartile, List<Double> samples) {
    public TimeSamples {
        samples = List.copyOf(samples);
    }

    /** Minimum number of samples for quartiles. */
    private static final int MIN_SAMPLES = 3;

    /** Returns whether two tasks differ significantly: both have quartiles, which do not overlap. */
    public boolean isDistinctFrom(TimeSamples other) {
        return Math.min(samples.size(), other.samples.size()) >= MIN_SAMPLES
                && (upperQuartile < other.lowerQuartile || other.upperQuartile < lowerQuartile);
    }

    public static TimeSamples of(Timing timing) {
        return new TimeSamples(timing.median(), timing.lowerQuartile(), timing.upperQuartile(), timing.milliseconds());
    }
}
