package lightning.scene.node;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Paths of nodes in a tree, as child indices from the outermost group. Remembers the last path, because an edit looks up one node many
 * times; finds that node and its siblings without a walk.
 */
public final class NodePaths {
    /** Last path found; empty for none. Any thread may replace it. */
    private volatile int[] lastPath;
    /** Number of nodes visited. */
    private long visitedCount;

    /** @param hint likely path of the next node; empty if unknown */
    NodePaths(int... hint) {
        lastPath = hint;
    }

    /** Returns the approximate number of nodes visited so far. */
    public long visitedCount() {
        return visitedCount;
    }

    /** Returns the path of the node of that name; null if there is none. */
    public int @Nullable [] find(List<SceneNode> nodes, String name) {
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

    /** Returns the node at a path; null if there is none. */
    public static @Nullable SceneNode nodeAt(List<SceneNode> nodes, int... path) {
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

    private int @Nullable [] search(List<SceneNode> nodes, String name, int depth) {
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
