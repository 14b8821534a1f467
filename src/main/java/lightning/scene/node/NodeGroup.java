package lightning.scene.node;

import java.util.List;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/**
 * Group of nodes; the placements of its children are relative to the group's.
 *
 * @param visible false hides all children
 */
public record NodeGroup(String name, Placement placement, List<SceneNode> children, boolean visible) implements SceneNode {
    public NodeGroup {
        SceneLimits.checkName(name);
        children = BlockList.copyOf(children);
    }

    /** Creates a visible group. */
    public NodeGroup(String name, Placement placement, List<SceneNode> children) {
        this(name, placement, children, true);
    }

    public NodeGroup withChildren(List<SceneNode> v) {
        return new NodeGroup(name, placement, v, visible);
    }

    @Override
    public NodeGroup withPlacement(Placement v) {
        return new NodeGroup(name, v, children, visible);
    }

    @Override
    public NodeGroup withVisible(boolean v) {
        return new NodeGroup(name, placement, children, v);
    }
}
