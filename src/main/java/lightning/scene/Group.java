package lightning.scene;

import java.util.List;

/**
 * Nodes that are placed together: their placements are inside the group's.
 *
 * @param visible whether what is in it is there at all, as far as that is visible itself
 */
public record Group(String name, Placement placement, List<Node> children, boolean visible) implements Node {
    public Group {
        Limits.name(name);
        children = BlockList.copyOf(children);
    }

    /** A visible one. */
    public Group(String name, Placement placement, List<Node> children) {
        this(name, placement, children, true);
    }

    public Group withChildren(List<Node> v) {
        return new Group(name, placement, v, visible);
    }

    @Override
    public Group withPlacement(Placement v) {
        return new Group(name, v, children, visible);
    }

    @Override
    public Group withVisible(boolean v) {
        return new Group(name, placement, children, v);
    }
}
