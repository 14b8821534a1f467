package lightning.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.bench.accuracy.AccuracySetting;
import lightning.bench.accuracy.PictureError;

/**
 * Compares results with older ones.
 *
 * <p>A time is worse where the quartiles do not overlap, the new ones above the old, and the median rose by more than
 * {@link #NOISE_PERCENT} percent, both in milliseconds and as a share of the full trace that was measured in turns with it:
 * a machine that is slower as a whole slows both. A picture is worse where any measure of its error rose at all: errors do not depend on
 * the machine.
 *
 * @param compared how many rungs of edits both results hold
 * @param worse    what became slower or less accurate, a line each
 */
public record BaselineComparison(int compared, List<String> worse) {
    /** By how much a median may rise, percent. */
    public static final double NOISE_PERCENT = 10;

    public BaselineComparison {
        worse = List.copyOf(worse);
    }

    /** Compares the rungs that both results hold. */
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

    /** A rung, and the median of the full trace that was measured in turns with it. */
    private record MeasuredPoint(SweepPointResult rung, double fullMs) {
        /** The time as a share of the full trace's; the full trace itself has only its own. */
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
