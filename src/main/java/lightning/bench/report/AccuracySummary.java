package lightning.bench.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;

/** Summary of one accuracy setting over all edits of a scene. */
record AccuracySummary(AccuracySetting setting, List<SweepPointResult> points) {

    /** Returns the measured settings. */
    static List<AccuracySummary> of(SceneResult scene) {
        List<AccuracySummary> summaries = new ArrayList<>();
        for (AccuracySetting setting : AccuracySetting.values()) {
            List<SweepPointResult> points = scene.edits().stream().flatMap(edit -> edit.values().stream())
                    .flatMap(value -> value.rungs().stream()).filter(point -> point.grade() == setting).toList();
            if (!points.isEmpty()) {
                summaries.add(new AccuracySummary(setting, points));
            }
        }
        return summaries;
    }

    /** Writes the table of all settings with their descriptions. */
    static void table(HtmlWriter page, List<AccuracySummary> summaries) {
        try (HtmlTable table = new HtmlTable(page, null, "Each accuracy setting over all edits: median time, worst error.",
                "setting", "time", "saves",
                "differing values", "max. ulp", "max. difference", "mean difference", "RMSE", "PSNR", "PSNR displayed", "SSIM",
                "ꟻLIP")) {
            summaries.forEach(summary -> table.row(summary.setting().label(), summary.cells()));
        }
        page.open("dl", "class", "grades");
        summaries.forEach(summary -> page.element("dt", summary.setting().label()).element("dd", summary.setting().description()));
        page.close();
    }

    AccuracyChart.Point point() {
        return new AccuracyChart.Point(setting, median(r -> r.time().lowerQuartile()), median(r -> r.time().median()),
                median(r -> r.time().upperQuartile()), max(PictureError::rmse));
    }

    /** Returns time, saving and errors as table cells. */
    String[] cells() {
        return new String[] {NumberText.ms(median()), NumberText.percent(saving()),
            differingShare(), NumberText.grouped((long) max(PictureError::maxUlp)),
            NumberText.error(max(PictureError::maxAbsolute)), NumberText.error(max(PictureError::meanAbsolute)),
            NumberText.error(rmse()), decibels(min(PictureError::linearPsnr)),
            decibels(min(PictureError::displayPsnr)), similarity(min(PictureError::ssim)), NumberText.error(flip())};
    }

    /** Returns the median time, milliseconds. */
    double median() {
        return median(r -> r.time().median());
    }

    /** Returns the median saving, percent of the full trace; uncertain savings count as the smallest. */
    double saving() {
        double saving = median(point -> Double.isNaN(point.saving()) ? Double.NEGATIVE_INFINITY : point.saving());
        return Double.isInfinite(saving) ? Double.NaN : saving;
    }

    /** Returns the maximum root mean square error. */
    double rmse() {
        return max(PictureError::rmse);
    }

    /** Returns the maximum ꟻLIP error, 0…1. */
    double flip() {
        return max(PictureError::flip);
    }

    /** Returns the maximum share of differing values, percent. */
    double percentDiffering() {
        return max(e -> 100.0 * e.values() / e.of());
    }

    /** Returns the maximum share of differing values as text. */
    private String differingShare() {
        return points.stream().map(SweepPointResult::error).max(Comparator.comparingDouble(e -> (double) e.values() / e.of()))
                .map(e -> NumberText.share(e.values(), e.of())).orElse("–");
    }

    static String decibels(double value) {
        return Double.isFinite(value) ? NumberText.threeDigits(value) + "\u00a0dB" : Double.isNaN(value) ? "–" : "∞";
    }

    static String similarity(double value) {
        return Double.isNaN(value) ? "–" : value == 1 ? "1" : String.format(Locale.ROOT, "%.5f", value);
    }

    private double median(ToDoubleFunction<SweepPointResult> value) {
        double[] sorted = points.stream().mapToDouble(value).sorted().toArray();
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }

    private double max(ToDoubleFunction<PictureError> value) {
        return points.stream().map(SweepPointResult::error).mapToDouble(value).max().orElse(Double.NaN);
    }

    private double min(ToDoubleFunction<PictureError> value) {
        return Arrays.stream(points.stream().map(SweepPointResult::error).mapToDouble(value).toArray()).min().orElse(Double.NaN);
    }
}
