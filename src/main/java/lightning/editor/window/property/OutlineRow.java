package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.collections.ObservableList;
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
    /** More lines that came or went are all made anew. */
    private static final int MOST = 1000;

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

    /**
     * Makes lines those of a stage. A line is a place, so that where no group is unfolded lines come and go at the end alone, and nothing is
     * walked.
     */
    static void update(ObservableList<OutlineRow> lines, Stage stage, Set<String> unfolded) {
        int before = lines.size();
        int now = stage.nodes().size();
        if (!unfolded.isEmpty() || before > 0 && lines.getLast().place != before - 1 || Math.abs(now - before) > MOST) {
            become(lines, of(stage, unfolded));
        } else if (now < before) {
            lines.subList(now, before).clear();
        } else if (now > before) {
            lines.addAll(IntStream.range(before, now).mapToObj(place -> new OutlineRow(null, place, 0)).toList());
        }
    }

    /** Touches those lines alone that are others, but for what is the same at both ends. */
    private static void become(ObservableList<OutlineRow> lines, List<OutlineRow> all) {
        int least = Math.min(lines.size(), all.size());
        int begin = 0;
        while (begin < least && lines.get(begin).equals(all.get(begin))) {
            begin++;
        }
        int same = 0;
        while (same < least - begin && lines.get(lines.size() - 1 - same).equals(all.get(all.size() - 1 - same))) {
            same++;
        }
        List<OutlineRow> come = all.subList(begin, all.size() - same);
        int end = lines.size() - same;
        if (end - begin == lines.size()) {
            lines.setAll(all);
        } else {
            lines.subList(begin, end).clear();
            lines.addAll(begin, come);
        }
    }

    /** The line of what stands at some places, as {@link Stage#places} gives them; −1 where a group around it is folded. */
    static int line(List<OutlineRow> lines, int... places) {
        OutlineRow row = null;
        for (int place : places) {
            row = new OutlineRow(row, place, row == null ? 0 : row.depth + 1);
        }
        // No line stands before its place.
        int from = places[0];
        return from < lines.size() && lines.get(from).equals(row) ? from : lines.indexOf(row);
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
