package lightning.scene;

import java.util.List;

/**
 * Where nodes stand in a tree: each by its place in the scene or in its group, the outermost group first. Who is asked for again, or stands
 * beside the one asked for last, is found without a walk: an edit asks for one node many times.
 */
final class NodePlaces {
    /** Of what was found last; empty for nothing. Whoever finds something else replaces it. */
    private volatile int[] last;
    /** How many nodes were looked at. */
    private long looked;

    /** @param near where the one that will be asked for may stand; empty for nothing known */
    NodePlaces(int... near) {
        last = near;
    }

    /** The nodes looked at so far, about. */
    long looked() {
        return looked;
    }

    /** The places of the node of that name; null where there is none. */
    int[] of(List<Node> nodes, String name) {
        int[] known = last;
        for (int beside = 0; known.length > 0 && beside < 3; beside++) {
            int[] places = known.clone();
            places[places.length - 1] += beside == 2 ? -1 : beside;
            Node node = at(nodes, places);
            looked++;
            if (node != null && node.name().equals(name)) {
                last = places;
                return places;
            }
        }
        int[] found = walk(nodes, name, 0);
        last = found == null ? known : found;
        return found;
    }

    /** What stands at some places; null where nothing does. */
    static Node at(List<Node> nodes, int... places) {
        List<Node> beside = nodes;
        Node node = null;
        for (int place : places) {
            if (place < 0 || place >= beside.size()) {
                return null;
            }
            node = beside.get(place);
            beside = node instanceof Group g ? g.children() : List.of();
        }
        return node;
    }

    private int[] walk(List<Node> nodes, String name, int depth) {
        for (int i = 0; i < nodes.size(); i++) {
            Node node = nodes.get(i);
            looked++;
            int[] found = node.name().equals(name) ? new int[depth + 1]
                    : node instanceof Group g ? walk(g.children(), name, depth + 1) : null;
            if (found != null) {
                found[depth] = i;
                return found;
            }
        }
        return null;
    }
}
