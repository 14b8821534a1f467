package lightning.scene;

import java.util.List;

/** Nodes that are placed together: their placements are inside the group's. */
public record Group(String name, Placement placement, List<Node> children) implements Node {
    public Group {
        Limits.name(name);
        children = List.copyOf(children);
    }
}
