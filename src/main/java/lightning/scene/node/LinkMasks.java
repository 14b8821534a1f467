package lightning.scene.node;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import lightning.scene.value.ShapeLinks;

/** Cache of link masks over the visible shapes, filled on demand. Thread-safe. */
final class LinkMasks {
    /** Maximum number of cached masks. */
    private static final int MAX_CACHED = 64;

    private final Map<ShapeLinks, boolean[]> cache = new ConcurrentHashMap<>();

    /**
     * Returns for each visible shape, in file order, whether it is linked; read-only.
     *
     * @param nodes the same list in every call
     * @param count number of visible shapes in the nodes
     */
    boolean[] get(List<SceneNode> nodes, int count, ShapeLinks links) {
        if (cache.size() > MAX_CACHED) {
            cache.clear();
        }
        return cache.computeIfAbsent(links, key -> {
            boolean[] mask = new boolean[count];
            fill(nodes, new HashSet<>(key.names()), key.exclusive(), false, mask, 0);
            return mask;
        });
    }

    /** @return the index after the last shape of the nodes */
    private static int fill(List<SceneNode> nodes, Set<String> names, boolean only, boolean parentNamed, boolean[] mask, int start) {
        int index = start;
        for (SceneNode node : nodes) {
            boolean isNamed = parentNamed || names.contains(node.name());
            switch (node) {
                case NodeGroup g when g.visible() -> index = fill(g.children(), names, only, isNamed, mask, index);
                case Shape s when s.visible() -> mask[index++] = isNamed == only;
                case SceneNode _ -> {}
            }
        }
        return index;
    }
}
