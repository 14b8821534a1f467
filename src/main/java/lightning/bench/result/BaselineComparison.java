package lightning.bench.result;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;

/**
 * Comparison of benchmark results with older ones.
 *
 * <p>A time is worse if the quartiles do not overlap and the median rose by more than {@link #NOISE_PERCENT} percent. Both must hold in
 * milliseconds and relative to the full trace measured in turns with it, as a slower machine slows both. An image is worse if any error
 * measure rose at all, as errors do not depend on the machine.
 *
 * @param compared number of measurements that both results have
 * @param worse    regressions in time or accuracy, one line each
 */
public record BaselineComparison(int compared, List<String> worse) {
    /** Tolerated rise of a median, in percent. */
    public static final double NOISE_PERCENT = 10;

    public BaselineComparison {
        worse = List.copyOf(worse);
    }

    /** Compares the measurements that both results have. */
    public static BaselineComparison compare(BenchResults previous, BenchResults current) {
        Map<String, MeasuredPoint> oldPoints = points(previous);
        List<String> worse = new ArrayList<>();
        int compared = 0;
        for (var entry : points(current).entrySet()) {
            MeasuredPoint before = oldPoints.get(entry.getKey());
            if (before != null) {
                compared++;
                addSlowdown(entry.getKey(), before, entry.getValue(), worse);
                addAccuracyLoss(entry.getKey(), before.rung().error(), entry.getValue().rung().error(), worse);
            }
        }
        return new BaselineComparison(compared, worse);
    }

    /** Measurement, and the median of the full trace measured in turns with it. */
    private record MeasuredPoint(SweepPointResult rung, double fullMs) {
        /** Returns the time relative to the full trace; for the full trace itself, its time. */
        double share() {
            return rung.grade() == AccuracySetting.FULL_TRACE ? rung.time().median() : rung.time().median() / fullMs;
        }
    }

    private static Map<String, MeasuredPoint> points(BenchResults results) {
        Map<String, MeasuredPoint> points = new LinkedHashMap<>();
        for (SceneResult scene : results.scenes()) {
            for (EditResult edit : scene.edits()) {
                for (ValueResult value : edit.values()) {
                    value.rungs()
                            .forEach(point -> points.put(String.join(", ", scene.scene() + " at " + scene.width() + "x" + scene.height(),
                                    edit.edit(), value.value(), point.grade().label()),
                                    new MeasuredPoint(point, value.rungs().getLast().time().median())));
                }
            }
        }
        return points;
    }

    private static void addSlowdown(String name, MeasuredPoint before, MeasuredPoint after, List<String> worse) {
        TimeSamples previous = before.rung().time();
        TimeSamples current = after.rung().time();
        double percent = 100 * (current.median() / previous.median() - 1);
        double sharePercent = 100 * (after.share() / before.share() - 1);
        if (current.lowerQuartile() > previous.upperQuartile() && Math.min(percent, sharePercent) > NOISE_PERCENT) {
            worse.add(String.format(Locale.ROOT, "slower: %s: %.3g ms, was %.3g (+%.0f %%)", name, current.median(), previous.median(),
                    percent));
        }
    }

    private static void addAccuracyLoss(String name, PictureError previous, PictureError current, List<String> worse) {
        List<String> measures = new ArrayList<>();
        addIfLarger(measures, "differing values", previous.values(), current.values());
        addIfLarger(measures, "maximum ulp", previous.maxUlp(), current.maxUlp());
        addIfLarger(measures, "maximum difference", previous.maxAbsolute(), current.maxAbsolute());
        addIfLarger(measures, "mean difference", previous.meanAbsolute(), current.meanAbsolute());
        addIfLarger(measures, "rmse", previous.rmse(), current.rmse());
        addIfLarger(measures, "1 - ssim", 1 - previous.ssim(), 1 - current.ssim());
        addIfLarger(measures, "flip", previous.flip(), current.flip());
        if (!measures.isEmpty()) {
            worse.add("less accurate: " + name + ": " + String.join(", ", measures));
        }
    }

    private static void addIfLarger(List<String> measures, String name, double previous, double current) {
        if (current > previous) {
            measures.add(String.format(Locale.ROOT, "%s %.6g, was %.6g", name, current, previous));
        }
    }
}
