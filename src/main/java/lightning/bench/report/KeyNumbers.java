package lightning.bench.report;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.EditResult;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.render.measure.AccuracySetting;

/** Four key numbers of a run at the default accuracy setting. Mixing settings would be misleading, as no single setting has all of them. */
final class KeyNumbers {
    private static final String AT_DEFAULT = "at setting " + AccuracySetting.DEFAULT.label() + " (default)";

    private KeyNumbers() {}

    static void write(HtmlWriter page, BenchResults results) {
        List<EditResult> edits = results.scenes().stream().flatMap(scene -> scene.edits().stream()).toList();
        if (edits.isEmpty()) {
            return;
        }
        double[] savings = sorted(edits.stream().mapToDouble(EditResult::saving));
        List<SweepPointResult> pictures = edits.stream().flatMap(edit -> edit.values().stream())
                .flatMap(value -> value.find(AccuracySetting.DEFAULT).stream()).toList();
        long equal = pictures.stream().filter(point -> point.error().values() == 0).count();
        double[] slowdowns = sorted(results.scenes().stream().map(SceneResult::firstPass).filter(f -> f != null)
                .mapToDouble(f -> f.percentSlower()));
        int uncertain = edits.size() - savings.length;
        page.open("dl", "class", "key");
        number(page, NumberText.percent(median(savings)),
                "of a full trace saved by the median edit " + AT_DEFAULT + "; the full trace is the "
                        + "fastest of this program" + (uncertain == 0 ? "" : "; " + uncertain + " of " + edits.size()
                                + " edits are left out because their timing is too noisy"));
        leastSaving(page, results);
        number(page, NumberText.grouped(equal) + " of " + NumberText.grouped(pictures.size()),
                "images " + AT_DEFAULT + " are bit-identical to the full trace");
        number(page, NumberText.percent(median(slowdowns)),
                "extra time of the median first pass over a full trace, to build the cache");
        page.close();
    }

    private static void leastSaving(HtmlWriter page, BenchResults results) {
        double minSaving = Double.NaN;
        String editLabel = "";
        for (SceneResult scene : results.scenes()) {
            for (EditResult edit : scene.edits()) {
                if (!Double.isNaN(edit.saving()) && !(edit.saving() >= minSaving)) {
                    minSaving = edit.saving();
                    editLabel = ": " + edit.edit() + " on " + SceneSection.title(scene);
                }
            }
        }
        number(page, NumberText.percent(minSaving), "saved " + AT_DEFAULT + " by the edit that saves least" + editLabel);
    }

    private static void number(HtmlWriter page, String value, String meaning) {
        page.open("div").element("dt", value).element("dd", meaning).close();
    }

    private static double[] sorted(DoubleStream values) {
        return values.filter(Double::isFinite).sorted().toArray();
    }

    private static double median(double[] sorted) {
        return Arrays.stream(sorted).skip((sorted.length - 1) / 2).limit(sorted.length % 2 == 0 ? 2 : 1).average().orElse(Double.NaN);
    }
}
