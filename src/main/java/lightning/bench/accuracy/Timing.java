package lightning.bench.accuracy;

import java.util.List;

/**
 * One work, measured again and again.
 *
 * @param milliseconds every sample in the order in which it was taken, each ≥ 0; at least one
 */
public record Timing(List<Double> milliseconds) {

    /** @throws IllegalArgumentException if there is no sample, or one that is negative or no number */
    public Timing {
        milliseconds = List.copyOf(milliseconds);
        if (milliseconds.isEmpty()) {
            throw new IllegalArgumentException("timing: expected at least one sample, found none");
        }
        for (double ms : milliseconds) {
            if (!(ms >= 0) || Double.isInfinite(ms)) {
                throw new IllegalArgumentException("timing: expected milliseconds ≥ 0, found " + ms);
            }
        }
    }

    public double median() {
        return quantile(0.5);
    }

    /** A quarter of the samples are below it. */
    public double lowerQuartile() {
        return quantile(0.25);
    }

    /** A quarter of the samples are above it. */
    public double upperQuartile() {
        return quantile(0.75);
    }

    /** How much of a work of {@code totalMs} milliseconds this one saves, in percent; negative where it takes longer. */
    public double percentSavedOf(double totalMs) {
        return 100 * (1 - median() / totalMs);
    }

    /** Between two samples it is interpolated (definition 7 of Hyndman and Fan, Sample Quantiles, 1996). */
    private double quantile(double fraction) {
        List<Double> sorted = milliseconds.stream().sorted().toList();
        double position = fraction * (sorted.size() - 1);
        int below = (int) position;
        int above = Math.min(below + 1, sorted.size() - 1);
        return sorted.get(below) + (position - below) * (sorted.get(above) - sorted.get(below));
    }
}
