package lightning.bench.report;

import lightning.bench.MeshPoint;
import lightning.bench.RayPace;
import lightning.bench.Results;

/** How fast rays are traced against meshes. */
final class MeshTable {
    private MeshTable() {}

    static void write(Markup page, Results results) {
        if (results.meshes().isEmpty()) {
            return;
        }
        page.open("section", "id", "meshes");
        page.leaf("h2", "Rays against meshes");
        page.leaf("p",
                "Generated balls with bumps; one thread, and the tree on all processors. Beside them Embree where it is installed, in "
                        + "turns: robust, packets of 16 and coherent, or single rays.",
                "class", "lead");
        try (Table table = new Table(page, "edits", "Million rays a second", "triangles, rays", "ours", "Embree's", "share")) {
            for (MeshPoint m : results.meshes()) {
                for (RayPace pace : m.rays()) {
                    table.row(Numbers.grouped(m.triangles()) + ", " + pace.rays(), Numbers.plain(pace.millions()),
                            pace.rival() == null ? "" : Numbers.plain(pace.rivalMillions()),
                            pace.rival() == null ? "" : Numbers.plain(pace.share()) + " %");
                }
            }
        }
        try (Table table = new Table(page, "edits", "Trees", "triangles", "ours", "Embree's", "bytes a triangle", "Embree's bytes")) {
            for (MeshPoint m : results.meshes()) {
                table.row(Numbers.grouped(m.triangles()), Numbers.ms(m.tree().median()),
                        m.rival() == null ? "" : Numbers.ms(m.rival().tree().median()), Numbers.plain(m.treeBytes()),
                        m.rival() == null ? "" : Numbers.plain(m.rival().treeBytes()));
            }
        }
        page.close();
    }
}
