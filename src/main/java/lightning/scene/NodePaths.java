package lightning.scene;

import java.util.List;

/**
 * Where nodes stand in a tree: each by its place in the scene or in its group, the outermost group first. Who is asked for again, or stands
 * beside the one asked for last, is found without a walk: an edit asks for one node many times.
 */
final class NodePaths {
    /** Of what was found last; empty for nothing. Whoever finds something else replaces it. */
    private volatile int[] lastPath;
    /** How many nodes were looked at. */
    private long visitedCount;

    /** @param hint where the one that will be asked for may stand; empty for nothing known */
    NodePaths(int... hint) {
        lastPath = hint;
    }

    /** The nodes looked at so far, about. */
    long visitedCount() {
        return visitedCount;
    }

    /** The places of the node of that name; null where there is none. */
    int[] find(List<SceneNode> nodes, String name) {
        int[] previous = lastPath;
        for (int attempt = 0; previous.length > 0 && attempt < 3; attempt++) {
            int[] path = previous.clone();
            path[path.length - 1] += attempt == 2 ? -1 : attempt;
            SceneNode node = nodeAt(nodes, path);
            visitedCount++;
            if (node != null && node.name().equals(name)) {
                lastPath = path;
                return path;
            }
        }
        int[] found = search(nodes, name, 0);
        lastPath = found == null ? previous : found;
        return found;
    }

    /** What stands at some places; null where nothing does. */
    static SceneNode nodeAt(List<SceneNode> nodes, int... path) {
        List<SceneNode> siblings = nodes;
        SceneNode node = null;
        for (int index : path) {
            if (index < 0 || index >= siblings.size()) {
                return null;
            }
            node = siblings.get(index);
            siblings = node instanceof NodeGroup g ? g.children() : List.of();
        }
        return node;
    }

    private int[] search(List<SceneNode> nodes, String name, int depth) {
        for (int i = 0; i < nodes.size(); i++) {
            SceneNode node = nodes.get(i);
            visitedCount++;
            int[] found = node.name().equals(name) ? new int[depth + 1]
                    : node instanceof NodeGroup g ? search(g.children(), name, depth + 1) : null;
            if (found != null) {
                found[depth] = i;
                return found;
            }
        }
        return null;
    }
}
