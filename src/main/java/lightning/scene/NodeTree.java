package lightning.scene;

import java.util.ArrayList;
import java.util.List;

/** The nodes, checked, with what must be known of them when materials or lights change. */
final class NodeTree {
    final List<Node> nodes;
    final NodeNames names;
    /** How many shapes there are. */
    final int count;
    /** How many shapes and groups are not visible by themselves. */
    private final int hidden;
    final MaterialUsers users;
    /** Stands for the groups with their names, and the places of all that is in them, told by identity. */
    final Object outline;
    /** Equal for equal nodes. */
    final long hash;
    final NodePlaces places;
    private final LinkedShapes linked = new LinkedShapes();
    /** Found when it is asked for; whoever finds it finds the same. */
    private List<Shape> shapes;

    /** @throws IllegalArgumentException as {@link Stage#Stage(List, List)}, but for materials */
    NodeTree(List<Node> nodes) {
        this.nodes = BlockList.copyOf(nodes);
        var all = new NodeSurvey(this.nodes, 0, 1, 1);
        count = Limits.range("the number of shapes", all.shapes.size(), 0, Limits.MAX_SHAPES);
        names = NodeNames.of(all.names);
        users = MaterialUsers.of(all.shapes);
        hidden = all.hidden;
        outline = new Object();
        hash = all.hash;
        places = new NodePlaces();
    }

    /**
     * Those of another with some in place of one.
     *
     * @throws IllegalArgumentException likewise
     */
    NodeTree(NodeTree before, NodeSplice splice) {
        nodes = splice.in(before.nodes);
        var gone = new NodeSurvey(List.of(splice.old), splice.nesting(), splice.least, splice.most);
        var came = new NodeSurvey(splice.by, splice.nesting(), splice.least, splice.most);
        count = Limits.range("the number of shapes", before.count - gone.shapes.size() + came.shapes.size(), 0, Limits.MAX_SHAPES);
        names = before.names.replacing(gone.names, came.names);
        users = before.users.replacing(MaterialUsers.of(gone.shapes), MaterialUsers.of(came.shapes))
                .orElseGet(() -> MaterialUsers.of(new NodeSurvey(nodes, 0, 1, 1).shapes));
        hidden = before.hidden - gone.hidden + came.hidden;
        outline = sameOutline(List.of(splice.old), splice.by) ? before.outline : new Object();
        hash = before.hash - gone.hash + came.hash;
        places = new NodePlaces(splice.places);
    }

    private static boolean sameOutline(List<? extends Node> a, List<? extends Node> b) {
        boolean same = a.size() == b.size();
        for (int i = 0; same && i < a.size(); i++) {
            same = a.get(i) == b.get(i) || switch (a.get(i)) {
                case Group g -> b.get(i) instanceof Group h && g.name().equals(h.name()) && sameOutline(g.children(), h.children());
                case Shape _ -> b.get(i) instanceof Shape;
            };
        }
        return same;
    }

    boolean[] linked(Links links) {
        return linked.of(nodes, shapes().size(), links);
    }

    /** All visible shapes in the order of the file; the nodes themselves where none is a group or hidden. */
    List<Shape> shapes() {
        List<Shape> found = shapes;
        if (found == null) {
            found = count == names.count() && hidden == 0 ? allShapes(nodes) : BlockList.copyOf(collect(nodes, new ArrayList<>(count)));
            shapes = found;
        }
        return found;
    }

    /** Nobody writes to the list: it is immutable. */
    @SuppressWarnings("unchecked")
    private static List<Shape> allShapes(List<? extends Node> nodes) {
        return (List<Shape>) nodes;
    }

    private static List<Shape> collect(List<Node> nodes, List<Shape> shapes) {
        for (Node node : nodes) {
            switch (node) {
                case Group g when g.visible() -> collect(g.children(), shapes);
                case Shape s when s.visible() -> shapes.add(s);
                case Node _ -> {}
            }
        }
        return shapes;
    }
}
