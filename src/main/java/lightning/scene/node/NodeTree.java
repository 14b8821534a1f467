package lightning.scene.node;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.Stage;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/** Checked tree of nodes, with the data needed when materials or lights change. */
public final class NodeTree {
    public final List<SceneNode> nodes;
    public final NodeNames names;
    /** Number of shapes. */
    public final int shapeCount;
    /** Number of shapes and groups that are hidden themselves. */
    private final int hiddenCount;
    public final MaterialUsers materialUsers;
    /** Identity of the tree's structure: its groups with their names and the positions of their children. */
    public final Object structure;
    /** Hash, equal for equal nodes. */
    public final long hash;
    public final NodePaths paths;
    private final LinkMasks linkMasks = new LinkMasks();
    private final GainEntries gainEntries = new GainEntries();
    /** Computed on demand; a race between threads computes the same list twice. */
    private @Nullable List<Shape> shapes;

    /** @throws IllegalArgumentException as {@link Stage#Stage(List, List)}, except for materials */
    public NodeTree(List<SceneNode> nodes) {
        this.nodes = BlockList.copyOf(nodes);
        var summary = new NodeSummary(this.nodes, 0, 1, 1);
        shapeCount = SceneLimits.checkRange("the number of objects", summary.shapes.size(), 0, SceneLimits.MAX_SHAPES);
        names = NodeNames.of(summary.names);
        materialUsers = MaterialUsers.of(summary.shapes);
        hiddenCount = summary.hiddenCount;
        structure = new Object();
        hash = summary.hash;
        paths = new NodePaths();
    }

    /**
     * Creates a tree from another by replacing one node.
     *
     * @throws IllegalArgumentException as {@link #NodeTree(List)}
     */
    public NodeTree(NodeTree before, NodeSplice splice) {
        nodes = splice.applyTo(before.nodes);
        var removed = new NodeSummary(List.of(splice.removed), splice.nesting(), splice.minScale, splice.maxScale);
        var added = new NodeSummary(splice.replacement, splice.nesting(), splice.minScale, splice.maxScale);
        shapeCount = SceneLimits.checkRange("the number of objects", before.shapeCount - removed.shapes.size() + added.shapes.size(), 0,
                SceneLimits.MAX_SHAPES);
        names = before.names.replace(removed.names, added.names);
        materialUsers = before.materialUsers.replace(MaterialUsers.of(removed.shapes), MaterialUsers.of(added.shapes))
                .orElseGet(() -> MaterialUsers.of(new NodeSummary(nodes, 0, 1, 1).shapes));
        hiddenCount = before.hiddenCount - removed.hiddenCount + added.hiddenCount;
        structure = sameOutline(List.of(splice.removed), splice.replacement) ? before.structure : new Object();
        hash = before.hash - removed.hash + added.hash;
        paths = new NodePaths(splice.path);
    }

    private static boolean sameOutline(List<? extends SceneNode> a, List<? extends SceneNode> b) {
        boolean same = a.size() == b.size();
        for (int i = 0; same && i < a.size(); i++) {
            same = a.get(i) == b.get(i) || switch (a.get(i)) {
                case NodeGroup g -> b.get(i) instanceof NodeGroup h && g.name().equals(h.name()) && sameOutline(g.children(), h.children());
                case Shape _ -> b.get(i) instanceof Shape;
            };
        }
        return same;
    }

    public boolean[] linkMask(ShapeLinks links) {
        return linkMasks.get(nodes, shapes().size(), links);
    }

    public short[] gainEntries(List<String> names) {
        return gainEntries.get(nodes, shapes().size(), names);
    }

    /** Returns all visible shapes in file order; the nodes themselves if none is a group or hidden. */
    public List<Shape> shapes() {
        List<Shape> found = shapes;
        if (found == null) {
            found = shapeCount == names.count() && hiddenCount == 0 ? allShapes(nodes)
                    : BlockList.copyOf(collect(nodes, new ArrayList<>(shapeCount)));
            shapes = found;
        }
        return found;
    }

    /** Safe because the list is immutable. */
    @SuppressWarnings("unchecked")
    private static List<Shape> allShapes(List<? extends SceneNode> nodes) {
        return (List<Shape>) nodes;
    }

    private static List<Shape> collect(List<SceneNode> nodes, List<Shape> shapes) {
        for (SceneNode node : nodes) {
            switch (node) {
                case NodeGroup g when g.visible() -> collect(g.children(), shapes);
                case Shape s when s.visible() -> shapes.add(s);
                case SceneNode _ -> {}
            }
        }
        return shapes;
    }
}
