package lightning.scene;

import java.util.List;

/** Nodes in place of one. */
final class NodeSplice {
    final int[] path;
    final List<? extends SceneNode> replacement;
    /** The node that goes. */
    final SceneNode removed;
    /** The products of the scales of the groups around it. */
    final double minScale;
    final double maxScale;

    /** @param path where the node stands that goes */
    NodeSplice(List<SceneNode> nodes, int[] path, List<? extends SceneNode> replacement) {
        this.path = path;
        this.replacement = replacement;
        removed = NodePaths.nodeAt(nodes, path);
        double outerMin = 1;
        double outerMax = 1;
        List<SceneNode> siblings = nodes;
        for (int depth = 0; depth < nesting(); depth++) {
            var group = (NodeGroup) siblings.get(path[depth]);
            outerMin *= group.placement().minScale();
            outerMax *= group.placement().maxScale();
            siblings = group.children();
        }
        minScale = outerMin;
        maxScale = outerMax;
    }

    /** In how many groups it happens. */
    int nesting() {
        return path.length - 1;
    }

    /** The nodes then. */
    List<SceneNode> applyTo(List<SceneNode> nodes) {
        return applyTo(nodes, 0);
    }

    private List<SceneNode> applyTo(List<SceneNode> nodes, int depth) {
        int index = path[depth];
        List<? extends SceneNode> children = depth == nesting() ? replacement : List.of(applyTo((NodeGroup) nodes.get(index), depth + 1));
        return BlockList.splice(nodes, index, index + 1, children);
    }

    private NodeGroup applyTo(NodeGroup group, int depth) {
        return group.withChildren(applyTo(group.children(), depth));
    }
}
