package lightning.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.bench.accuracy.Grade;
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
public record Baseline(int compared, List<String> worse) {
    /** By how much a median may rise, percent. */
    public static final double NOISE_PERCENT = 10;

    public Baseline {
        worse = List.copyOf(worse);
    }

    /** Compares the rungs that both results hold. */
    public static Baseline compare(Results old, Results now) {
        Map<String, Measured> known = rungs(old);
        List<String> worse = new ArrayList<>();
        int compared = 0;
        for (var entry : rungs(now).entrySet()) {
            Measured before = known.get(entry.getKey());
            if (before != null) {
                compared++;
                slower(entry.getKey(), before, entry.getValue(), worse);
                rougher(entry.getKey(), before.rung().error(), entry.getValue().rung().error(), worse);
            }
        }
        return new Baseline(compared, worse);
    }

    /** A rung, and the median of the full trace that was measured in turns with it. */
    private record Measured(RungResult rung, double fullMs) {
        /** The time as a share of the full trace's; the full trace itself has only its own. */
        double share() {
            return rung.grade() == Grade.FULL_TRACE ? rung.time().median() : rung.time().median() / fullMs;
        }
    }

    private static Map<String, Measured> rungs(Results results) {
        Map<String, Measured> rungs = new LinkedHashMap<>();
        for (SceneResult scene : results.scenes()) {
            for (EditResult edit : scene.edits()) {
                for (ValueResult value : edit.values()) {
                    value.rungs().forEach(rung -> rungs.put(String.join(", ", scene.scene() + " at " + scene.width() + "x" + scene.height(),
                            edit.edit(), value.value(), rung.grade().label()),
                            new Measured(rung, value.rungs().getLast().time().median())));
                }
            }
        }
        return rungs;
    }

    private static void slower(String what, Measured before, Measured after, List<String> worse) {
        Samples old = before.rung().time();
        Samples now = after.rung().time();
        double percent = 100 * (now.median() / old.median() - 1);
        double sharePercent = 100 * (after.share() / before.share() - 1);
        if (now.lowerQuartile() > old.upperQuartile() && Math.min(percent, sharePercent) > NOISE_PERCENT) {
            worse.add(String.format(Locale.ROOT, "slower: %s: %.3g ms, was %.3g (+%.0f %%)", what, now.median(), old.median(), percent));
        }
    }

    private static void rougher(String what, PictureError old, PictureError now, List<String> worse) {
        List<String> measures = new ArrayList<>();
        rose(measures, "values that differ", old.values(), now.values());
        rose(measures, "largest ulp", old.maxUlp(), now.maxUlp());
        rose(measures, "largest difference", old.maxAbsolute(), now.maxAbsolute());
        rose(measures, "mean difference", old.meanAbsolute(), now.meanAbsolute());
        rose(measures, "rmse", old.rmse(), now.rmse());
        rose(measures, "1 - ssim", 1 - old.ssim(), 1 - now.ssim());
        rose(measures, "flip", old.flip(), now.flip());
        if (!measures.isEmpty()) {
            worse.add("less accurate: " + what + ": " + String.join(", ", measures));
        }
    }

    private static void rose(List<String> measures, String name, double old, double now) {
        if (now > old) {
            measures.add(String.format(Locale.ROOT, "%s %.6g, was %.6g", name, now, old));
        }
    }
}
