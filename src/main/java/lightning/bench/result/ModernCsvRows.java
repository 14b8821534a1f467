package lightning.bench.result;

import java.util.ArrayList;
import java.util.List;
import lightning.render.measure.PictureError;
import org.jspecify.annotations.Nullable;

/** CSV rows of the modern set. Kinds are as in {@link CsvRow} with the prefix {@code modern-}; the level is the anti-aliasing. */
final class ModernCsvRows {
    private static final String PREFIX = "modern-";

    private ModernCsvRows() {}

    static List<CsvRow> of(ModernScene scene) {
        List<CsvRow> rows = new ArrayList<>();
        for (ModernPicture picture : scene.pictures()) {
            if (picture.firstPass() != null) {
                rows.add(row(scene, picture, "first-pass", "", "", picture.firstPass().time(), Double.NaN));
                rows.add(row(scene, picture, "full-trace", "", "", picture.firstPass().fullTrace(), Double.NaN));
            }
            picture.edits().forEach(edit -> rows.add(row(scene, picture, "edit", edit.edit(), edit.value(), edit.time(), edit.saving())));
            if (picture.cold() != null) {
                cold(rows, scene, picture, picture.cold());
            }
        }
        for (ErrorCurve curve : scene.curves()) {
            curve.points().forEach(point -> rows.add(CsvRow.row(PREFIX + "error", scene.scene(), curve.width(), curve.height(), "",
                    curve.program(), point.setting(), point.time(), Double.NaN, Double.NaN, CsvRow.NO_WORK,
                    error(point.error()))));
        }
        return rows;
    }

    /** Returns an error of which only the root mean square difference is known. */
    private static PictureError error(double rmse) {
        return new PictureError(0, 0, 0, Double.NaN, Double.NaN, rmse, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }

    private static void cold(List<CsvRow> rows, ModernScene scene, ModernPicture picture, ColdStart cold) {
        process(rows, scene, picture, "cold", "", cold.process(), cold.processor());
        if (cold.rival() != null) {
            process(rows, scene, picture, "cold-peer", cold.rival().program(), cold.rival().process(), cold.rival().processor());
        }
    }

    private static void process(List<CsvRow> rows, ModernScene scene, ModernPicture picture, String kind, String program, TimeSamples wall,
            @Nullable TimeSamples processor) {
        rows.add(row(scene, picture, kind, "", program, wall, Double.NaN));
        if (processor != null) {
            rows.add(row(scene, picture, kind + "-processor", "", program, processor, Double.NaN));
        }
    }

    private static CsvRow row(ModernScene scene, ModernPicture picture, String kind, String edit, String value, TimeSamples time,
            double saving) {
        boolean isCold = kind.startsWith("cold");
        return CsvRow.row(PREFIX + kind, scene.scene(), isCold ? picture.coldWidth() : picture.width(),
                isCold ? picture.coldHeight() : picture.height(), edit, value, picture.sampling().label(), time, saving, Double.NaN,
                CsvRow.NO_WORK, CsvRow.NO_ERROR);
    }
}
