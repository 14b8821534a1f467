package lightning.bench;

import java.util.List;
import lightning.bench.accuracy.Timing;

/**
 * One work's times, milliseconds.
 *
 * @param median        of all samples
 * @param lowerQuartile a quarter of the samples are below it
 * @param upperQuartile a quarter of the samples are above it
 * @param samples       every sample in the order in which it was taken
 */
public record TimeSamples(double median, double lowerQuartile, double upperQuartile, List<Double> samples) {
    public TimeSamples {
        samples = List.copyOf(samples);
    }

    /** With fewer samples quartiles say nothing. */
    private static final int MIN_SAMPLES = 3;

    /** Whether it is certain which of two works takes longer: both have quartiles, and these do not overlap. */
    boolean isDistinctFrom(TimeSamples other) {
        return Math.min(samples.size(), other.samples.size()) >= MIN_SAMPLES
                && (upperQuartile < other.lowerQuartile || other.upperQuartile < lowerQuartile);
    }

    static TimeSamples of(Timing timing) {
        return new TimeSamples(timing.median(), timing.lowerQuartile(), timing.upperQuartile(), timing.milliseconds());
    }
}
