package lightning.scene.node;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Cache that finds for each visible shape the gain of a light that applies to it, filled on demand. Thread-safe. */
final class GainEntries {
    /** Maximum number of cached lists of names. */
    private static final int MAX_CACHED = 64;

    private final Map<List<String>, short[]> cache = new ConcurrentHashMap<>();

    /**
     * Returns for each visible shape, in file order, the position after that of the innermost named node in the list of names: its own name
     * or that of a group; 0 if none is named. Read-only.
     *
     * @param nodes the same list in every call
     * @param count number of visible shapes in the nodes
     */
    short[] get(List<SceneNode> nodes, int count, List<String> names) {
        if (cache.size() > MAX_CACHED) {
            cache.clear();
        }
        return cache.computeIfAbsent(names, key -> {
            Map<String, Short> entries = HashMap.newHashMap(key.size());
            key.forEach(name -> entries.put(name, (short) (entries.size() + 1)));
            short[] found = new short[count];
            fill(nodes, entries, (short) 0, found, 0);
            return found;
        });
    }

    /** @return the index after the last shape of the nodes */
    private static int fill(List<SceneNode> nodes, Map<String, Short> entries, short outer, short[] found, int start) {
        int index = start;
        for (SceneNode node : nodes) {
            short entry = entries.getOrDefault(node.name(), outer);
            switch (node) {
                case NodeGroup g when g.visible() -> index = fill(g.children(), entries, entry, found, index);
                case Shape s when s.visible() -> found[index++] = entry;
                case SceneNode _ -> {}
            }
        }
        return index;
    }
}
