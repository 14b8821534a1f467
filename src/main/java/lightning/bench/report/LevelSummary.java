package lightning.bench.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import lightning.accuracy.Level;
import lightning.accuracy.PictureError;
import lightning.bench.EditResult;
import lightning.bench.RungResult;
import lightning.bench.SceneResult;

/** One level of accuracy over all edits of a scene. */
record LevelSummary(Level level, List<RungResult> rungs) {

    /** The levels that were measured. */
    static List<LevelSummary> of(SceneResult scene) {
        List<LevelSummary> levels = new ArrayList<>();
        for (Level level : Level.values()) {
            List<RungResult> rungs = scene.edits().stream().flatMap(edit -> edit.values().stream())
                    .flatMap(value -> value.rungs().stream()).filter(rung -> rung.level() == level).toList();
            if (!rungs.isEmpty()) {
                levels.add(new LevelSummary(level, rungs));
            }
        }
        return levels;
    }

    /** Writes the table of all levels and what each of them is. */
    static void table(Markup page, List<LevelSummary> levels) {
        try (Table table = new Table(page, null, "Each level over all edits: median time; worst error.", "level", "time", "saves",
                "values that differ", "largest ulp", "largest difference", "mean difference", "RMSE", "PSNR", "PSNR displayed", "SSIM",
                "ꟻLIP")) {
            levels.forEach(level -> table.row(level.level().label(), level.cells()));
        }
        page.open("dl", "class", "levels");
        levels.forEach(level -> page.leaf("dt", level.level().label()).leaf("dd", level.level().note()));
        page.close();
    }

    /** A level of an edit's first value. */
    static Optional<RungResult> first(EditResult edit, Level level) {
        return edit.values().stream().flatMap(value -> value.rungs().stream()).filter(rung -> rung.level() == level).findFirst();
    }

    /** What a level saves, the average of an edit's values; NaN where it was not measured. */
    static double saving(EditResult edit, Level level) {
        return edit.values().stream().flatMap(value -> value.rungs().stream()).filter(rung -> rung.level() == level)
                .mapToDouble(RungResult::saving).average().orElse(Double.NaN);
    }

    LadderChart.Point point() {
        return new LadderChart.Point(level, median(r -> r.time().lowerQuartile()), median(r -> r.time().median()),
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

    /** The median of what is saved, percent of the full trace. */
    double saving() {
        return median(RungResult::saving);
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
