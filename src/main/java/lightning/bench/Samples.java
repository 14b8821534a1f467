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
public record Samples(double median, double lowerQuartile, double upperQuartile, List<Double> samples) {
    public Samples {
        samples = List.copyOf(samples);
    }

    /** With fewer samples quartiles say nothing. */
    private static final int LEAST_SAMPLES = 3;

    /** Whether it is certain which of two works takes longer: both have quartiles, and these do not overlap. */
    boolean isApart(Samples other) {
        return Math.min(samples.size(), other.samples.size()) >= LEAST_SAMPLES
                && (upperQuartile < other.lowerQuartile || other.upperQuartile < lowerQuartile);
    }

    static Samples of(Timing timing) {
        return new Samples(timing.median(), timing.lowerQuartile(), timing.upperQuartile(), timing.milliseconds());
    }
}
