package lightning.scene;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Which visible shapes links name: found when it is asked for, and kept. Shared between threads. */
final class LinkedShapes {
    /** Of so many links it is kept which shapes they are. */
    private static final int MOST = 64;

    private final Map<Links, boolean[]> known = new ConcurrentHashMap<>();

    /**
     * Of each visible shape, in the order of the file, whether it is among those linked; not to be written to.
     *
     * @param nodes always the same
     * @param count how many visible shapes there are in them
     */
    boolean[] of(List<Node> nodes, int count, Links links) {
        if (known.size() > MOST) {
            known.clear();
        }
        return known.computeIfAbsent(links, asked -> {
            boolean[] found = new boolean[count];
            mark(nodes, new HashSet<>(asked.names()), asked.only(), false, found, 0);
            return found;
        });
    }

    /** @return the place of the shape behind those of the nodes */
    private static int mark(List<Node> nodes, Set<String> names, boolean only, boolean named, boolean[] found, int from) {
        int at = from;
        for (Node node : nodes) {
            boolean here = named || names.contains(node.name());
            switch (node) {
                case Group g when g.visible() -> at = mark(g.children(), names, only, here, found, at);
                case Shape s when s.visible() -> found[at++] = here == only;
                case Node _ -> {}
            }
        }
        return at;
    }
}
