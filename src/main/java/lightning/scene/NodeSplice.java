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
        return depth == nesting() ? spliced(nodes, place, by)
                : spliced(nodes, place, List.of(in((Group) nodes.get(place), depth + 1)));
    }

    private Group in(Group group, int depth) {
        return group.withChildren(in(group.children(), depth));
    }

    @SuppressWarnings("unchecked")
    private static List<Node> spliced(List<Node> nodes, int at, List<? extends Node> by) {
        // As objects: each of a hundred thousand nodes would be asked for its type.
        Object[] all = nodes.toArray();
        if (by.size() == 1) {
            all[at] = by.getFirst();
        } else {
            Object[] before = all;
            all = new Object[before.length - 1 + by.size()];
            System.arraycopy(before, 0, all, 0, at);
            System.arraycopy(by.toArray(), 0, all, at, by.size());
            System.arraycopy(before, at + 1, all, at + by.size(), before.length - 1 - at);
        }
        return (List<Node>) (List<?>) List.of(all);
    }
}
