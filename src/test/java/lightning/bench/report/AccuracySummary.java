package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;

/** Summary of one accuracy setting over all edits of a scene, as in the report. */
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

    private double median(ToDoubleFunction<SweepPointResult> value) {
        double[] sorted = points.stream().mapToDouble(value).sorted().toArray();
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }

    private double max(ToDoubleFunction<PictureError> value) {
        return points.stream().map(SweepPointResult::error).mapToDouble(value).max().orElse(Double.NaN);
    }
}
