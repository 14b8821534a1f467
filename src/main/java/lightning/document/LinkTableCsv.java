package lightning.document;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import tools.jackson.dataformat.csv.CsvMapper;

/** The links between all lights and objects as a table of comma-separated values (RFC 4180). */
public final class LinkTableCsv {
    private LinkTableCsv() {}

    /**
     * Returns the table: a row for each shape and group with the names of its groups before its own, and a column for each light. A cell is the gain, 0
     * without a link; empty if only some objects of a group are linked.
     */
    public static byte[] of(Scene scene) {
        LinkTable table = LinkTable.of(scene, Set.of(), "");
        List<List<String>> rows = new ArrayList<>();
        List<String> head = new ArrayList<>(List.of("object"));
        table.lights().forEach(light -> head.add(light.name()));
        rows.add(head);
        for (LinkTable.Row row : table.rows()) {
            List<String> cells = new ArrayList<>(List.of(String.join("/", row.path())));
            for (Light light : table.lights()) {
                LinkTable.Link link = LinkTable.link(light, row);
                cells.add(switch (link.state()) {
                    case ON -> Double.toString(link.gain());
                    case OFF -> "0";
                    case MIXED -> "";
                });
            }
            rows.add(cells);
        }
        return new CsvMapper().writeValueAsString(rows).getBytes(StandardCharsets.UTF_8);
    }
}
