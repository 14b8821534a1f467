package lightning.scene;

import java.util.List;

/** Nodes in place of one. */
final class NodeSplice {
    final int[] places;
    final List<? extends Node> by;
    /** The node that goes. */
    final Node old;
    /** The products of the scales of the groups around it. */
    final double least;
    final double most;

    /** @param places where the node stands that goes */
    NodeSplice(List<Node> nodes, int[] places, List<? extends Node> by) {
        this.places = places;
        this.by = by;
        old = NodePlaces.at(nodes, places);
        double outerLeast = 1;
        double outerMost = 1;
        List<Node> beside = nodes;
        for (int depth = 0; depth < nesting(); depth++) {
            var group = (Group) beside.get(places[depth]);
            outerLeast *= group.placement().leastScale();
            outerMost *= group.placement().mostScale();
            beside = group.children();
        }
        least = outerLeast;
        most = outerMost;
    }

    /** In how many groups it happens. */
    int nesting() {
        return places.length - 1;
    }

    /** The nodes then. */
    List<Node> in(List<Node> nodes) {
        return in(nodes, 0);
    }

    private List<Node> in(List<Node> nodes, int depth) {
        int place = places[depth];
        List<? extends Node> then = depth == nesting() ? by : List.of(in((Group) nodes.get(place), depth + 1));
        return BlockList.spliced(nodes, place, place + 1, then);
    }

    private Group in(Group group, int depth) {
        return group.withChildren(in(group.children(), depth));
    }
}
