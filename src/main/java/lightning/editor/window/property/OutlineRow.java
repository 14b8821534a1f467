package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.collections.ObservableList;
import lightning.scene.Stage;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import org.jspecify.annotations.Nullable;

/**
 * Row of the shape list, by index path in the tree. Cells look up the content.
 *
 * @param group  row of the enclosing group
 * @param index  index in the group or the scene
 * @param depth  number of enclosing groups
 */
record OutlineRow(@Nullable OutlineRow group, int index, int depth) {
    /** Maximum number of rows added or removed incrementally. */
    private static final int MAX_INCREMENTAL = 1000;

    /** Returns the row's node, or null if it does not exist. */
    @Nullable
    SceneNode node(Stage stage) {
        List<SceneNode> siblings = group == null ? stage.nodes() : group.node(stage) instanceof NodeGroup g ? g.children() : List.of();
        return index < siblings.size() ? siblings.get(index) : null;
    }

    /**
     * Returns all rows in file order.
     *
     * @param expandedGroups  names of the expanded groups
     */
    static List<OutlineRow> of(Stage stage, Set<String> expandedGroups) {
        List<OutlineRow> rows = new ArrayList<>(stage.nodes().size());
        add(null, 0, stage.nodes(), expandedGroups, rows);
        return rows;
    }

    /** Updates rows for a stage. Since rows are index paths, a tree without expanded groups changes only at the end and is not walked. */
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

    /** Replaces the rows between the common prefix and suffix. */
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

    /** Returns the row of an index path as {@link Stage#path} returns it, or −1 if an enclosing group is collapsed. */
    static int indexOf(List<OutlineRow> lines, int... indices) {
        OutlineRow row = null;
        for (int index : indices) {
            row = new OutlineRow(row, index, row == null ? 0 : row.depth + 1);
        }
        // A row's position is at least its top-level index.
        int from = indices[0];
        return from < lines.size() && lines.get(from).equals(row) ? from : lines.indexOf(row);
    }

    private static void add(@Nullable OutlineRow group, int depth, List<SceneNode> nodes, Set<String> expandedGroups,
            List<OutlineRow> rows) {
        for (int i = 0; i < nodes.size(); i++) {
            var row = new OutlineRow(group, i, depth);
            rows.add(row);
            if (nodes.get(i) instanceof NodeGroup g && expandedGroups.contains(g.name())) {
                add(row, depth + 1, g.children(), expandedGroups, rows);
            }
        }
    }
}
