package lightning.bench.report;

import lightning.bench.result.BenchResults;
import lightning.bench.result.EditingCost;

/** Table of editing costs in large scenes, without a window. */
final class EditingTable {
    private EditingTable() {}

    static void write(HtmlWriter page, BenchResults results) {
        if (results.editing().isEmpty()) {
            return;
        }
        page.open("section", "id", "editing");
        page.element("h2", "Editing large scenes");
        page.element("p", "Generated scenes: balls over a floor, with lights of all types. Tracing is not included.", "class",
                "lead");
        try (HtmlTable table =
                new HtmlTable(page, "edits", "Scene operations without the window: medians, and heap bytes per shape", "shapes, lights",
                        "load", "tree", "new scene", "plan", "first hover", "document", "primitives and tree")) {
            for (EditingCost e : results.editing()) {
                table.row(NumberText.grouped(e.shapes()) + ", " + NumberText.grouped(e.lights()), NumberText.ms(e.load().median()),
                        NumberText.ms(e.tree().median()), NumberText.ms(e.newScene().median()), NumberText.ms(e.plan().median()),
                        NumberText.ms(e.hover().median()), bytes(e.documentBytes()), bytes(e.treeBytes()));
            }
        }
        page.close();
    }

    private static String bytes(double v) {
        return Double.isNaN(v) ? "" : NumberText.threeDigits(v) + " B";
    }
}
