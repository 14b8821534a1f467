package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.collections.ObservableList;
import lightning.scene.NodeGroup;
import lightning.scene.SceneNode;
import lightning.scene.Stage;

/**
 * One line of the list of shapes, by its places in the tree: what stands there is the cell's to show.
 *
 * @param group the line of the group that it is in; null for none
 * @param index in the group, or in the scene
 * @param depth how many groups it is in
 */
record OutlineRow(OutlineRow group, int index, int depth) {
    /** More lines that came or went are all made anew. */
    private static final int MAX_INCREMENTAL = 1000;

    /** What stands there; null where nothing does. */
    SceneNode node(Stage stage) {
        List<SceneNode> siblings = group == null ? stage.nodes() : group.node(stage) instanceof NodeGroup g ? g.children() : List.of();
        return index < siblings.size() ? siblings.get(index) : null;
    }

    /**
     * All lines, in the order of the file.
     *
     * @param expandedGroups the names of the groups that are listed with what is in them
     */
    static List<OutlineRow> of(Stage stage, Set<String> expandedGroups) {
        List<OutlineRow> rows = new ArrayList<>(stage.nodes().size());
        add(null, 0, stage.nodes(), expandedGroups, rows);
        return rows;
    }

    /**
     * Makes lines those of a stage. A line is a place, so that where no group is unfolded lines come and go at the end alone, and nothing is
     * walked.
     */
    static void update(ObservableList<OutlineRow> lines, Stage stage, Set<String> expandedGroups) {
        int oldCount = lines.size();
        int newCount = stage.nodes().size();
        if (!expandedGroups.isEmpty() || oldCount > 0 && lines.getLast().index != oldCount - 1
                || Math.abs(newCount - oldCount) > MAX_INCREMENTAL) {
            replaceChanged(lines, of(stage, expandedGroups));
        } else if (newCount < oldCount) {
            lines.subList(newCount, oldCount).clear();
        } else if (newCount > oldCount) {
            lines.addAll(IntStream.range(oldCount, newCount).mapToObj(place -> new OutlineRow(null, place, 0)).toList());
        }
    }

    /** Touches those lines alone that are others, but for what is the same at both ends. */
    private static void replaceChanged(ObservableList<OutlineRow> lines, List<OutlineRow> newLines) {
        int minSize = Math.min(lines.size(), newLines.size());
        int prefix = 0;
        while (prefix < minSize && lines.get(prefix).equals(newLines.get(prefix))) {
            prefix++;
        }
        int suffix = 0;
        while (suffix < minSize - prefix && lines.get(lines.size() - 1 - suffix).equals(newLines.get(newLines.size() - 1 - suffix))) {
            suffix++;
        }
        List<OutlineRow> inserted = newLines.subList(prefix, newLines.size() - suffix);
        int end = lines.size() - suffix;
        if (end - prefix == lines.size()) {
            lines.setAll(newLines);
        } else {
            lines.subList(prefix, end).clear();
            lines.addAll(prefix, inserted);
        }
    }

    /** The line of what stands at some places, as {@link Stage#path} gives them; −1 where a group around it is folded. */
    static int indexOf(List<OutlineRow> lines, int... indices) {
        OutlineRow row = null;
        for (int place : indices) {
            row = new OutlineRow(row, place, row == null ? 0 : row.depth + 1);
        }
        // No line stands before its place.
        int from = indices[0];
        return from < lines.size() && lines.get(from).equals(row) ? from : lines.indexOf(row);
    }

    private static void add(OutlineRow group, int depth, List<SceneNode> nodes, Set<String> expandedGroups, List<OutlineRow> rows) {
        for (int i = 0; i < nodes.size(); i++) {
            var row = new OutlineRow(group, i, depth);
            rows.add(row);
            if (nodes.get(i) instanceof NodeGroup g && expandedGroups.contains(g.name())) {
                add(row, depth + 1, g.children(), expandedGroups, rows);
            }
        }
    }
}
