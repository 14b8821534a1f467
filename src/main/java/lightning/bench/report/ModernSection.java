package lightning.bench.report;

import lightning.bench.result.BenchResults;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ErrorPoint;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernScene;

/** Report section of the modern set. */
final class ModernSection {
    private ModernSection() {}

    static void write(HtmlWriter page, BenchResults results) {
        if (results.modern().isEmpty()) {
            return;
        }
        page.open("section", "id", "modern");
        page.element("h2", "Modern scenes");
        page.element("p", "With and without anti-aliasing. Errors are root mean square differences as displayed from each program's own "
                + "image of many samples.", "class", "lead");
        page.open("div", "class", "charts");
        results.modern().stream().filter(scene -> !scene.curves().isEmpty()).forEach(scene -> SceneSection.figure(page, scene.scene(),
                "Error against time (ms).", ModernCharts.svg(scene)));
        page.close();
        try (HtmlTable table = new HtmlTable(page, "edits", "Updates after one edit", "scene, anti-aliasing, edit", "update", "full trace",
                "saves")) {
            for (ModernScene scene : results.modern()) {
                for (ModernPicture picture : scene.pictures()) {
                    picture.edits().forEach(edit -> row(table, scene, picture, edit));
                }
            }
        }
        try (HtmlTable table =
                new HtmlTable(page, "edits", "Time and error of anti-aliasing", "scene, program, setting", "time", "error")) {
            for (ModernScene scene : results.modern()) {
                for (ErrorCurve curve : scene.curves()) {
                    curve.points().forEach(point -> row(table, scene, curve, point));
                }
            }
        }
        page.close();
    }

    private static void row(HtmlTable table, ModernScene scene, ModernPicture picture, ModernEdit edit) {
        table.row(scene.scene() + ", " + picture.sampling().label() + ", " + edit.edit(), NumberText.ms(edit.time().median()),
                NumberText.ms(edit.fullTrace().median()), NumberText.percent(edit.saving()));
    }

    private static void row(HtmlTable table, ModernScene scene, ErrorCurve curve, ErrorPoint point) {
        table.row(scene.scene() + ", " + curve.program() + ", " + point.setting(), NumberText.ms(point.time().median()),
                NumberText.error(point.error()));
    }
}
