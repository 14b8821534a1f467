package lightning.bench.report;

import lightning.bench.BenchResults;
import lightning.bench.MeshPoint;
import lightning.bench.RayThroughput;

/** How fast rays are traced against meshes. */
final class MeshTable {
    private MeshTable() {}

    static void write(HtmlWriter page, BenchResults results) {
        if (results.meshes().isEmpty()) {
            return;
        }
        page.open("section", "id", "meshes");
        page.element("h2", "Rays against meshes");
        page.element("p",
                "Generated balls with bumps; one thread, and the tree on all processors. Beside them Embree where it is installed, in "
                        + "turns: robust, packets of 16 and coherent, or single rays.",
                "class", "lead");
        try (HtmlTable table = new HtmlTable(page, "edits", "Million rays a second", "triangles, rays", "ours", "Embree's", "share")) {
            for (MeshPoint m : results.meshes()) {
                for (RayThroughput pace : m.rays()) {
                    table.row(NumberText.grouped(m.triangles()) + ", " + pace.rays(), NumberText.threeDigits(pace.millionsPerSecond()),
                            pace.rival() == null ? "" : NumberText.threeDigits(pace.rivalMillionsPerSecond()),
                            pace.rival() == null ? "" : NumberText.threeDigits(pace.share()) + " %");
                }
            }
        }
        try (HtmlTable table =
                new HtmlTable(page, "edits", "Trees", "triangles", "ours", "Embree's", "bytes a triangle", "Embree's bytes")) {
            for (MeshPoint m : results.meshes()) {
                table.row(NumberText.grouped(m.triangles()), NumberText.ms(m.tree().median()),
                        m.rival() == null ? "" : NumberText.ms(m.rival().tree().median()), NumberText.threeDigits(m.treeBytes()),
                        m.rival() == null ? "" : NumberText.threeDigits(m.rival().treeBytes()));
            }
        }
        page.close();
    }
}
