package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;

/** Findings of the modern set as sentences with measured values, one per list item. */
final class ModernFindings {
    private ModernFindings() {}

    static String list(List<ModernScene> scenes) {
        List<String> items = new ArrayList<>();
        List<ModernEdit> edits = pictures(scenes).flatMap(p -> p.edits().stream()).toList();
        long differing = edits.stream().filter(edit -> !edit.equal()).count();
        items.add("**Exactness**: of " + edits.size() + " edited images, " + (edits.size() - differing)
                + " were equal to a full trace in every bit.");
        for (ModernSampling sampling : ModernSampling.values()) {
            items.add("**Edits, anti-aliasing " + sampling.label() + "**: the median edit saves " + medianSaving(scenes, sampling)
                    + " of a full trace; the first pass is "
                    + range(scenes, "%.0f", sampling, p -> p.firstPass() == null ? Double.NaN : p.firstPass().percentSlower())
                    + " % slower than a full trace." + losses(scenes, sampling));
        }
        for (ModernSampling sampling : ModernSampling.values()) {
            items.add("**Cold processes, anti-aliasing " + sampling.label() + "**: `lightning render` takes "
                    + range(scenes, "%.2f", sampling,
                            p -> p.cold() == null || p.cold().rival() == null ? Double.NaN : p.cold().rival().share())
                    + " of the time of POV-Ray with `" + sampling.povRayLabel() + "`"
                    + (sampling == ModernSampling.NONE ? "." : ", which is not the same work."));
        }
        List<EqualError> comparisons = scenes.stream().flatMap(s -> EqualError.of(s).stream()).toList();
        items.add("**At the error of POV-Ray's `" + ModernSampling.EDGES.povRayLabel() + "`**, "
                + equalError(comparisons.stream().filter(e -> !e.isOurs()).toList(), "Lightning's"));
        items.add("**At the error of Lightning's `" + ModernSampling.EDGES.label() + "`**, "
                + equalError(comparisons.stream().filter(EqualError::isOurs).toList(), "POV-Ray's"));
        return items.stream().map(item -> "- " + item + "\n").collect(Collectors.joining());
    }

    private static String equalError(List<EqualError> comparisons, String other) {
        String speed = ReportStatements.range("%.2f", comparisons.stream().map(EqualError::timesAsFast));
        String less = comparisons.stream().filter(e -> e.other().isEmpty()).map(EqualError::scene).collect(Collectors.joining(", "));
        return "Lightning is " + speed + " times as fast."
                + (less.isEmpty() ? "" : " No measured setting of " + other + " is as accurate on " + less + ".");
    }

    private static String medianSaving(List<ModernScene> scenes, ModernSampling sampling) {
        double[] savings = pictures(scenes).filter(p -> p.sampling() == sampling).flatMap(p -> p.edits().stream())
                .mapToDouble(ModernEdit::saving).filter(Double::isFinite).sorted().toArray();
        double median = DoubleStream.of(savings).skip((savings.length - 1) / 2).limit(savings.length % 2 == 0 ? 2 : 1).average()
                .orElse(Double.NaN);
        return Double.isNaN(median) ? "–" : String.format(Locale.ROOT, "%.0f %%", median);
    }

    /** Returns a sentence about edits that are slower than a full trace; empty if there are none. */
    private static String losses(List<ModernScene> scenes, ModernSampling sampling) {
        String slower = scenes.stream().flatMap(s -> s.pictures().stream().filter(p -> p.sampling() == sampling)
                .flatMap(p -> p.edits().stream()).filter(edit -> edit.saving() < 0)
                .map(edit -> edit.edit().replace('-', ' ') + " on `" + s.scene() + "`")).collect(Collectors.joining(", "));
        return slower.isEmpty() ? "" : " Slower than a full trace: " + slower + ".";
    }

    private static String range(List<ModernScene> scenes, String pattern, ModernSampling sampling, Function<ModernPicture, Double> value) {
        return ReportStatements.range(pattern, pictures(scenes).filter(p -> p.sampling() == sampling).map(value));
    }

    private static Stream<ModernPicture> pictures(List<ModernScene> scenes) {
        return scenes.stream().flatMap(s -> s.pictures().stream());
    }
}
