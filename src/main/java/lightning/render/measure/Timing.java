package lightning.render.measure;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;

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

    /**
     * Times the first pass of a scene; the renderer then has its picture.
     *
     * @param repetitions number of samples after one warm-up, ≥ 1
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    static Timing ofFirstPass(Renderer renderer, Scene scene, int repetitions, Progress progress) {
        List<Double> times = new ArrayList<>();
        for (int i = -1; i < repetitions; i++) {
            renderer.clear();
            double ms = renderer.render(scene, progress.cancellationOnly()).milliseconds();
            if (i >= 0) {
                times.add(ms);
            }
        }
        return new Timing(times);
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
