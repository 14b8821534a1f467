package lightning.scene.node;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Quote;
import lightning.scene.value.SceneLimits;

/** Flat summary of all nodes of a tree, in file order, checked against the limits. */
final class NodeSummary {
    final List<String> names = new ArrayList<>();
    final List<Shape> shapes = new ArrayList<>();
    /** Number of nodes that are hidden themselves. */
    int hiddenCount;
    /** Sum of the hashes of the nodes. */
    long hash;

    NodeSummary(List<? extends SceneNode> nodes, int nesting, double minScale, double maxScale) {
        add(nodes, nesting, minScale, maxScale);
    }

    private void add(List<? extends SceneNode> nodes, int nesting, double minScale, double maxScale) {
        SceneLimits.checkRange("the nesting of groups", nesting, 0, SceneLimits.MAX_NESTING);
        for (SceneNode node : nodes) {
            names.add(node.name());
            hiddenCount += node.visible() ? 0 : 1;
            double min = minScale * node.placement().minScale();
            double max = maxScale * node.placement().maxScale();
            SceneLimits.checkCombinedScale(() -> "shape " + Quote.of(node.name()), min, max);
            switch (node) {
                case NodeGroup g -> {
                    hash += mixHash(31 * g.name().hashCode() + g.placement().hashCode(), g.visible());
                    add(g.children(), nesting + 1, min, max);
                }
                case Shape s -> {
                    hash += mixHash(s.hashCode(), true);
                    shapes.add(s);
                }
            }
        }
    }

    /** Mixes the bits, so that sums distinguish nodes whose hashes have few set bits. */
    private static long mixHash(int hash, boolean visible) {
        long mixed = (hash * 2L + (visible ? 1 : 0)) * 0x9E3779B97F4A7C15L;
        return (mixed ^ mixed >>> 32) * 0xD6E8FEB86659FD93L;
    }
}
