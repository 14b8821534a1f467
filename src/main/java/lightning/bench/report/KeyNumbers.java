package lightning.bench.report;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import lightning.bench.EditResult;
import lightning.bench.Results;
import lightning.bench.RungResult;
import lightning.bench.SceneResult;
import lightning.bench.accuracy.Grade;

/** The run in four numbers, all of the default grade: a headline that mixes grades would promise what none of them keeps. */
final class KeyNumbers {
    private static final String GRADE = "at grade " + Grade.DEFAULT.label() + " (the program's default)";

    private KeyNumbers() {}

    static void write(Markup page, Results results) {
        List<EditResult> edits = results.scenes().stream().flatMap(scene -> scene.edits().stream()).toList();
        if (edits.isEmpty()) {
            return;
        }
        double[] savings = sorted(edits.stream().mapToDouble(EditResult::saving));
        List<RungResult> pictures = edits.stream().flatMap(edit -> edit.values().stream())
                .flatMap(value -> value.find(Grade.DEFAULT).stream()).toList();
        long equal = pictures.stream().filter(rung -> rung.error().values() == 0).count();
        double[] first = sorted(results.scenes().stream().map(SceneResult::firstPass).filter(f -> f != null)
                .mapToDouble(f -> f.percentSlower()));
        int uncertain = edits.size() - savings.length;
        page.open("dl", "class", "key");
        number(page, Numbers.percent(median(savings)),
                "of a full trace is saved by the median edit " + GRADE + ", the full trace being the "
                        + "fastest that the program can make" + (uncertain == 0 ? "" : "; " + uncertain + " of " + edits.size()
                                + " edits are left out, whose times scatter too much to say"));
        least(page, results);
        number(page, Numbers.grouped(equal) + " of " + Numbers.grouped(pictures.size()),
                "pictures " + GRADE + " equal the full trace in every bit");
        number(page, Numbers.percent(median(first)), "is what the median first pass takes beyond a full trace, to keep what edits need");
        page.close();
    }

    private static void least(Markup page, Results results) {
        double least = Double.NaN;
        String which = "";
        for (SceneResult scene : results.scenes()) {
            for (EditResult edit : scene.edits()) {
                if (!Double.isNaN(edit.saving()) && !(edit.saving() >= least)) {
                    least = edit.saving();
                    which = ": " + edit.edit() + " on " + SceneSection.title(scene);
                }
            }
        }
        number(page, Numbers.percent(least), "is saved " + GRADE + " by the edit that saves least" + which);
    }

    private static void number(Markup page, String value, String meaning) {
        page.open("div").leaf("dt", value).leaf("dd", meaning).close();
    }

    private static double[] sorted(DoubleStream values) {
        return values.filter(Double::isFinite).sorted().toArray();
    }

    private static double median(double[] sorted) {
        return Arrays.stream(sorted).skip((sorted.length - 1) / 2).limit(sorted.length % 2 == 0 ? 2 : 1).average().orElse(Double.NaN);
    }
}
