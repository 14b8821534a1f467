package lightning.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.accuracy.PictureError;

/**
 * Compares results with older ones.
 *
 * <p>A time is worse where the quartiles do not overlap, the new ones above the old, and the median rose by more than
 * {@link #NOISE_PERCENT} percent. A picture is worse where any measure of its error rose at all: errors do not depend on
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
        Map<String, RungResult> known = rungs(old);
        List<String> worse = new ArrayList<>();
        int compared = 0;
        for (var entry : rungs(now).entrySet()) {
            RungResult before = known.get(entry.getKey());
            if (before != null) {
                compared++;
                slower(entry.getKey(), before.time(), entry.getValue().time(), worse);
                rougher(entry.getKey(), before.error(), entry.getValue().error(), worse);
            }
        }
        return new Baseline(compared, worse);
    }

    private static Map<String, RungResult> rungs(Results results) {
        Map<String, RungResult> rungs = new LinkedHashMap<>();
        for (SceneResult scene : results.scenes()) {
            for (EditResult edit : scene.edits()) {
                for (ValueResult value : edit.values()) {
                    value.rungs().forEach(rung -> rungs.put(String.join(", ", scene.scene() + " at " + scene.width() + "x" + scene.height(),
                            edit.edit(), value.value(), rung.level().label()), rung));
                }
            }
        }
        return rungs;
    }

    private static void slower(String what, Samples old, Samples now, List<String> worse) {
        double percent = 100 * (now.median() / old.median() - 1);
        if (now.lowerQuartile() > old.upperQuartile() && percent > NOISE_PERCENT) {
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
