package lightning.render.measure;

import java.util.List;

/**
 * Repeated timing of one task.
 *
 * @param milliseconds samples in order of measurement, each ≥ 0; at least one
 */
public record Timing(List<Double> milliseconds) {

    /** @throws IllegalArgumentException if there is no sample, or one that is negative or NaN */
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

    /** Returns the first quartile of the samples. */
    public double lowerQuartile() {
        return quantile(0.25);
    }

    /** Returns the third quartile of the samples. */
    public double upperQuartile() {
        return quantile(0.75);
    }

    /** Returns the saving relative to a task of {@code totalMs} milliseconds, in percent; negative if slower. */
    public double percentSavedOf(double totalMs) {
        return 100 * (1 - median() / totalMs);
    }

    /** Returns a quantile, interpolated between two samples (definition 7 of Hyndman and Fan, Sample Quantiles, 1996). */
    private double quantile(double fraction) {
        List<Double> sorted = milliseconds.stream().sorted().toList();
        double position = fraction * (sorted.size() - 1);
        int below = (int) position;
        int above = Math.min(below + 1, sorted.size() - 1);
        return sorted.get(below) + (position - below) * (sorted.get(above) - sorted.get(below));
    }
}
