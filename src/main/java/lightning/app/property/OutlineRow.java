package lightning.app.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import lightning.scene.Group;
import lightning.scene.Node;
import lightning.scene.Stage;

/**
 * One line of the list of shapes, by its places in the tree: what stands there is the cell's to show.
 *
 * @param group the line of the group that it is in; null for none
 * @param place in the group, or in the scene
 * @param depth how many groups it is in
 */
record OutlineRow(OutlineRow group, int place, int depth) {

    /** What stands there; null where nothing does. */
    Node node(Stage stage) {
        List<Node> beside = group == null ? stage.nodes() : group.node(stage) instanceof Group g ? g.children() : List.of();
        return place < beside.size() ? beside.get(place) : null;
    }

    /**
     * All lines, in the order of the file.
     *
     * @param unfolded the names of the groups that are listed with what is in them
     */
    static List<OutlineRow> of(Stage stage, Set<String> unfolded) {
        List<OutlineRow> rows = new ArrayList<>(stage.nodes().size());
        add(null, 0, stage.nodes(), unfolded, rows);
        return rows;
    }

    private static void add(OutlineRow group, int depth, List<Node> nodes, Set<String> unfolded, List<OutlineRow> rows) {
        for (int i = 0; i < nodes.size(); i++) {
            var row = new OutlineRow(group, i, depth);
            rows.add(row);
            if (nodes.get(i) instanceof Group g && unfolded.contains(g.name())) {
                add(row, depth + 1, g.children(), unfolded, rows);
            }
        }
    }
}
