package lightning.scene;

import java.util.List;

/**
 * Nodes that are placed together: their placements are inside the group's.
 *
 * @param visible whether what is in it is there at all, as far as that is visible itself
 */
public record NodeGroup(String name, Placement placement, List<SceneNode> children, boolean visible) implements SceneNode {
    public NodeGroup {
        SceneLimits.checkName(name);
        children = BlockList.copyOf(children);
    }

    /** A visible one. */
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
