package lightning.scene;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Which visible shapes links name: found when it is asked for, and kept. Shared between threads. */
final class LinkMasks {
    /** Of so many links it is kept which shapes they are. */
    private static final int MAX_CACHED = 64;

    private final Map<ShapeLinks, boolean[]> cache = new ConcurrentHashMap<>();

    /**
     * Of each visible shape, in the order of the file, whether it is among those linked; not to be written to.
     *
     * @param nodes always the same
     * @param count how many visible shapes there are in them
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

    /** @return the place of the shape behind those of the nodes */
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
