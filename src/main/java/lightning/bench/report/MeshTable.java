package lightning.bench.report;

import lightning.bench.result.BenchResults;
import lightning.bench.result.MeshPoint;
import lightning.bench.result.RayThroughput;

/** Tables of ray throughput on meshes. */
final class MeshTable {
    private MeshTable() {}

    static void write(HtmlWriter page, BenchResults results) {
        if (results.meshes().isEmpty()) {
            return;
        }
        page.open("section", "id", "meshes");
        page.element("h2", "Ray tracing of meshes");
        page.element("p",
                "Generated bumpy spheres. Rays on one thread, BVH build on all processors. Embree, if installed, is measured in "
                        + "turns: robust, coherent packets of 16, or single rays.",
                "class", "lead");
        try (HtmlTable table = new HtmlTable(page, "edits", "Million rays per second", "triangles, rays", "Lightning", "Embree", "ratio")) {
            for (MeshPoint m : results.meshes()) {
                for (RayThroughput pace : m.rays()) {
                    table.row(NumberText.grouped(m.triangles()) + ", " + pace.rays(), NumberText.threeDigits(pace.millionsPerSecond()),
                            pace.rival() == null ? "" : NumberText.threeDigits(pace.rivalMillionsPerSecond()),
                            pace.rival() == null ? "" : NumberText.threeDigits(pace.share()) + " %");
                }
            }
        }
        try (HtmlTable table =
                new HtmlTable(page, "edits", "BVH build", "triangles", "Lightning", "Embree", "bytes per triangle", "Embree, bytes")) {
            for (MeshPoint m : results.meshes()) {
                table.row(NumberText.grouped(m.triangles()), NumberText.ms(m.tree().median()),
                        m.rival() == null ? "" : NumberText.ms(m.rival().tree().median()), NumberText.threeDigits(m.treeBytes()),
                        m.rival() == null ? "" : NumberText.threeDigits(m.rival().treeBytes()));
            }
        }
        page.close();
    }
}
