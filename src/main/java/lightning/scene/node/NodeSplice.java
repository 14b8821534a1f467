package lightning.scene.node;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** Replacement of one node by several. */
public final class NodeSplice {
    final int[] path;
    final List<? extends SceneNode> replacement;
    /** The replaced node. */
    public final @Nullable SceneNode removed;
    /** Products of the scales of the enclosing groups. */
    final double minScale;
    final double maxScale;

    /** @param path path of the replaced node */
    public NodeSplice(List<SceneNode> nodes, int[] path, List<? extends SceneNode> replacement) {
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

    /** Returns the number of enclosing groups. */
    int nesting() {
        return path.length - 1;
    }

    /** Returns the nodes with the replacement applied. */
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
