package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Quote;

/** All that is in some nodes, checked for limits: in the order of the file. */
final class NodeSurvey {
    final List<String> names = new ArrayList<>();
    final List<Shape> shapes = new ArrayList<>();
    /** How many shapes and groups are not visible by themselves. */
    int hidden;
    /** A sum over the nodes, each by itself. */
    long hash;

    NodeSurvey(List<? extends Node> nodes, int nesting, double leastScale, double mostScale) {
        take(nodes, nesting, leastScale, mostScale);
    }

    private void take(List<? extends Node> nodes, int nesting, double leastScale, double mostScale) {
        Limits.range("the nesting of groups", nesting, 0, Limits.MAX_NESTING);
        for (Node node : nodes) {
            names.add(node.name());
            hidden += node.visible() ? 0 : 1;
            double least = leastScale * node.placement().leastScale();
            double most = mostScale * node.placement().mostScale();
            Limits.combinedScale(() -> "shape " + Quote.of(node.name()), least, most);
            switch (node) {
                case Group g -> {
                    hash += spread(31 * g.name().hashCode() + g.placement().hashCode(), g.visible());
                    take(g.children(), nesting + 1, least, most);
                }
                case Shape s -> {
                    hash += spread(s.hashCode(), true);
                    shapes.add(s);
                }
            }
        }
    }

    /** So that sums of few bits tell nodes apart. */
    private static long spread(int hash, boolean visible) {
        long mixed = (hash * 2L + (visible ? 1 : 0)) * 0x9E3779B97F4A7C15L;
        return (mixed ^ mixed >>> 32) * 0xD6E8FEB86659FD93L;
    }
}
