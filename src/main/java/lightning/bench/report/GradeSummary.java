package lightning.bench.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import lightning.bench.RungResult;
import lightning.bench.SceneResult;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.PictureError;

/** One grade of accuracy over all edits of a scene. */
record GradeSummary(Grade grade, List<RungResult> rungs) {

    /** The grades that were measured. */
    static List<GradeSummary> of(SceneResult scene) {
        List<GradeSummary> grades = new ArrayList<>();
        for (Grade grade : Grade.values()) {
            List<RungResult> rungs = scene.edits().stream().flatMap(edit -> edit.values().stream())
                    .flatMap(value -> value.rungs().stream()).filter(rung -> rung.grade() == grade).toList();
            if (!rungs.isEmpty()) {
                grades.add(new GradeSummary(grade, rungs));
            }
        }
        return grades;
    }

    /** Writes the table of all grades and what each of them is. */
    static void table(Markup page, List<GradeSummary> grades) {
        try (Table table = new Table(page, null, "Each grade over all edits: median time; worst error.", "grade", "time", "saves",
                "values that differ", "largest ulp", "largest difference", "mean difference", "RMSE", "PSNR", "PSNR displayed", "SSIM",
                "ꟻLIP")) {
            grades.forEach(grade -> table.row(grade.grade().label(), grade.cells()));
        }
        page.open("dl", "class", "grades");
        grades.forEach(grade -> page.leaf("dt", grade.grade().label()).leaf("dd", grade.grade().note()));
        page.close();
    }

    LadderChart.Point point() {
        return new LadderChart.Point(grade, median(r -> r.time().lowerQuartile()), median(r -> r.time().median()),
                median(r -> r.time().upperQuartile()), worst(PictureError::rmse));
    }

    /** Time, saving and errors, for a table. */
    String[] cells() {
        return new String[] {Numbers.ms(median()), Numbers.percent(saving()),
            differing(), Numbers.grouped((long) worst(PictureError::maxUlp)),
            Numbers.error(worst(PictureError::maxAbsolute)), Numbers.error(worst(PictureError::meanAbsolute)),
            Numbers.error(rmse()), decibels(least(PictureError::linearPsnr)),
            decibels(least(PictureError::displayPsnr)), similarity(least(PictureError::ssim)), Numbers.error(flip())};
    }

    /** The median time, milliseconds. */
    double median() {
        return median(r -> r.time().median());
    }

    /** The median of what is saved, percent of the full trace; where it is not certain of an edit, that counts as the least. */
    double saving() {
        double saving = median(rung -> Double.isNaN(rung.saving()) ? Double.NEGATIVE_INFINITY : rung.saving());
        return Double.isInfinite(saving) ? Double.NaN : saving;
    }

    /** The largest root mean square error. */
    double rmse() {
        return worst(PictureError::rmse);
    }

    /** The largest ꟻLIP error, 0…1. */
    double flip() {
        return worst(PictureError::flip);
    }

    /** The largest share of values that differ, percent. */
    double percentDiffering() {
        return worst(e -> 100.0 * e.values() / e.of());
    }

    /** The largest share of values that differ. */
    private String differing() {
        return rungs.stream().map(RungResult::error).max(Comparator.comparingDouble(e -> (double) e.values() / e.of()))
                .map(e -> Numbers.share(e.values(), e.of())).orElse("–");
    }

    static String decibels(double value) {
        return Double.isFinite(value) ? Numbers.plain(value) + "\u00a0dB" : Double.isNaN(value) ? "–" : "∞";
    }

    static String similarity(double value) {
        return Double.isNaN(value) ? "–" : value == 1 ? "1" : String.format(Locale.ROOT, "%.5f", value);
    }

    private double median(ToDoubleFunction<RungResult> of) {
        double[] sorted = rungs.stream().mapToDouble(of).sorted().toArray();
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }

    private double worst(ToDoubleFunction<PictureError> of) {
        return rungs.stream().map(RungResult::error).mapToDouble(of).max().orElse(Double.NaN);
    }

    private double least(ToDoubleFunction<PictureError> of) {
        return Arrays.stream(rungs.stream().map(RungResult::error).mapToDouble(of).toArray()).min().orElse(Double.NaN);
    }
}
