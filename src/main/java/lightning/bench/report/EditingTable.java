package lightning.bench.report;

import lightning.bench.Editing;
import lightning.bench.Results;

/** What editing large scenes costs below the editor. */
final class EditingTable {
    private EditingTable() {}

    static void write(Markup page, Results results) {
        if (results.editing().isEmpty()) {
            return;
        }
        page.open("section", "id", "editing");
        page.leaf("h2", "Editing large scenes");
        page.leaf("p", "Generated scenes: balls over a floor, under lights of all types. What an edit traces is not in here.", "class",
                "lead");
        try (Table table =
                new Table(page, "edits", "Below the editor's window: medians, and bytes of heap for each shape", "shapes, lights",
                        "load", "tree", "new scene", "plan", "first hover", "document", "primitives and tree")) {
            for (Editing e : results.editing()) {
                table.row(Numbers.grouped(e.shapes()) + ", " + Numbers.grouped(e.lights()), Numbers.ms(e.load().median()),
                        Numbers.ms(e.tree().median()), Numbers.ms(e.newScene().median()), Numbers.ms(e.plan().median()),
                        Numbers.ms(e.hover().median()), bytes(e.documentBytes()), bytes(e.treeBytes()));
            }
        }
        page.close();
    }

    private static String bytes(double v) {
        return Double.isNaN(v) ? "" : Numbers.plain(v) + " B";
    }
}
