package lightning.bench.result;

import java.util.ArrayList;
import java.util.List;
import lightning.render.measure.PictureError;

/** CSV rows of indirect light. Kinds start with {@code indirect-}; errors are relative. */
final class IndirectCsvRows {
    private static final String PREFIX = "indirect-";

    private IndirectCsvRows() {}

    static List<CsvRow> of(IndirectResults results) {
        List<CsvRow> rows = new ArrayList<>();
        for (IndirectAccuracy scene : results.accuracy()) {
            scene.points().forEach(point -> rows.add(row("error", scene.scene(), scene.width(), scene.height(), "",
                    "spacing " + point.spacing() + ", rays " + point.rays() + ", bounces " + point.bounces(), point.time(),
                    error(point.error().mean()))));
        }
        for (ReflectionAccuracy scene : results.reflections()) {
            scene.points().forEach(point -> rows.add(row("reflection-error", scene.scene(), scene.width(), scene.height(), "",
                    "rays " + point.rays(), point.time(), error(point.mean()))));
        }
        for (SoftShadowAccuracy scene : results.softShadows()) {
            scene.points().forEach(point -> rows.add(row("shadow-error", scene.scene(), scene.width(), scene.height(), "",
                    "samples " + point.samples(), point.time(), error(point.mean()))));
        }
        for (IndirectCost scene : results.costs()) {
            rows.add(cost(scene, "first-pass", "", "", scene.first()));
            rows.add(cost(scene, "first-pass-without", "", "", scene.without()));
            rows.add(cost(scene, "full-trace", "", "", scene.fullTrace()));
            for (IndirectCost.Edit edit : scene.edits()) {
                rows.add(cost(scene, "edit", edit.edit(), edit.value(), edit.time()));
                rows.add(cost(scene, "edit-without", edit.edit(), edit.value(), edit.without()));
            }
        }
        for (IndirectGrowth growth : results.growth()) {
            for (IndirectGrowth.Point point : growth.points()) {
                rows.add(growth(growth, point, "first-pass", point.first()));
                rows.add(growth(growth, point, "first-pass-without", point.without()));
                rows.add(growth(growth, point, "intensity", point.intensity()));
                rows.add(growth(growth, point, "position", point.position()));
            }
        }
        for (IndirectAbsence scene : results.absence()) {
            rows.add(row("absent", scene.scene(), scene.width(), scene.height(), "", "", scene.absent(), CsvRow.NO_ERROR));
            rows.add(row("hidden", scene.scene(), scene.width(), scene.height(), "", "", scene.hidden(), CsvRow.NO_ERROR));
        }
        return rows;
    }

    private static PictureError error(double mean) {
        return new PictureError(0, 0, 0, Double.NaN, mean, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }

    private static CsvRow cost(IndirectCost scene, String kind, String edit, String value, TimeSamples time) {
        return row(kind, scene.scene(), scene.width(), scene.height(), edit, value, time, CsvRow.NO_ERROR);
    }

    private static CsvRow growth(IndirectGrowth growth, IndirectGrowth.Point point, String edit, TimeSamples time) {
        return row("growth", growth.scene(), 0, 0, growth.along() + ", " + edit, Long.toString(point.at()), time, CsvRow.NO_ERROR);
    }

    private static CsvRow row(String kind, String scene, int width, int height, String edit, String value, TimeSamples time,
            PictureError error) {
        return CsvRow.row(PREFIX + kind, scene, width, height, edit, value, "", time, Double.NaN, Double.NaN, CsvRow.NO_WORK, error);
    }
}
