package lightning.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import lightning.base.math.Transform;
import lightning.base.text.Quote;

/**
 * What stands before the camera: shapes, in groups, and their materials. Checked once, when it is made, and shared by all
 * scenes that differ in lights or views only. Two stages are equal when their nodes and materials are; the same one is
 * known at once.
 */
public final class Stage {
    /** Nothing at all. */
    public static final Stage EMPTY = new Stage(List.of(), List.of());

    private final NodeTree tree;
    private final List<Material> materials;
    private final Map<String, Material> materialsByName;
    /** Of those with the sharpest highlights the first; {@code null} where no light's term can be above 1. */
    private final Material sharpestMaterial;

    /**
     * @param materials names unique among themselves
     * @param nodes     shapes and groups, names unique; each shape's material is the name of one of {@code materials}, or
     *                  {@code default} where none has that name
     * @throws IllegalArgumentException if a name is taken or a material missing, if there are more shapes, materials or
     *                                  nested groups than {@link SceneLimits} allows, or if scales multiply beyond its range
     */
    public Stage(List<Material> materials, List<SceneNode> nodes) {
        this(materials, new NodeTree(nodes));
    }

    private Stage(List<Material> materials, NodeTree tree) {
        this.materials = List.copyOf(materials);
        this.tree = tree;
        SceneLimits.checkRange("the number of materials", this.materials.size(), 0, SceneLimits.MAX_MATERIALS);
        Map<String, Material> materialMap = HashMap.newHashMap(this.materials.size() + 1);
        Material sharpest = null;
        for (Material material : this.materials) {
            sharpest = material.maxTerm() > (sharpest == null ? 1 : sharpest.maxTerm()) ? material : sharpest;
            if (materialMap.put(material.name(), material) != null) {
                throw new IllegalArgumentException("material " + Quote.of(material.name()) + ": the name is already taken");
            }
        }
        materialMap.putIfAbsent(Material.DEFAULT.name(), Material.DEFAULT);
        materialsByName = Map.copyOf(materialMap);
        sharpestMaterial = sharpest;
        tree.materialUsers.check(materialsByName.keySet());
    }

    /** These shapes with other materials. */
    public Stage withMaterials(List<Material> v) {
        return v.equals(materials) ? this : new Stage(v, tree);
    }

    /** These materials on other shapes. */
    public Stage withNodes(List<SceneNode> v) {
        return v.equals(nodes()) ? this : new Stage(materials, new NodeTree(v));
    }

    public List<Material> materials() {
        return materials;
    }

    public List<SceneNode> nodes() {
        return tree.nodes;
    }

    /** Every material that a shape may name, {@code default} included. */
    public Map<String, Material> materialsByName() {
        return materialsByName;
    }

    /** The material whose highlights multiply a light the most, of several the first; empty where none makes it brighter than it is. */
    Optional<Material> sharpestMaterial() {
        return Optional.ofNullable(sharpestMaterial);
    }

    /** The names of the materials that shapes have, in the order of the first shapes that have them; nothing is walked. */
    public Set<String> usedMaterials() {
        return tree.materialUsers.materials();
    }

    /** How many shapes there are, those in groups and those that are not visible included. */
    public int shapeCount() {
        return tree.shapeCount;
    }

    /** Whether a shape or a group has the name. */
    public boolean hasNode(String name) {
        return tree.names.contains(name);
    }

    /** The shape or the group of that name. */
    public Optional<SceneNode> node(String name) {
        return path(name).map(places -> NodePaths.nodeAt(nodes(), places));
    }

    /**
     * Where the shape or the group of that name stands: its places in the groups around it, the outermost first, and in the innermost; at
     * least one. Empty where there is none.
     */
    public Optional<int[]> path(String name) {
        return hasNode(name) ? Optional.of(tree.paths.find(nodes(), name)) : Optional.empty();
    }

    /** The groups around the shape or the group of that name, the outermost first; none where there is none of that name. */
    public List<NodeGroup> enclosingGroups(String name) {
        int[] path = path(name).orElse(new int[1]);
        return IntStream.range(1, path.length).mapToObj(n -> (NodeGroup) NodePaths.nodeAt(nodes(), Arrays.copyOf(path, n))).toList();
    }

    /** How many nodes were looked at to find some by their names. */
    long visitedNodes() {
        return tree.paths.visitedCount();
    }

    /**
     * This stage with none, one or several nodes in place of that name's; itself where there is none of that name. What is known of all
     * others serves on, so that it takes little time however many there are.
     *
     * @throws IllegalArgumentException as {@link #Stage(List, List)}
     */
    public Stage replaceNode(String name, List<? extends SceneNode> replacement) {
        Optional<int[]> path = path(name);
        if (path.isEmpty()) {
            return this;
        }
        var splice = new NodeSplice(nodes(), path.get(), replacement);
        return replacement.equals(List.of(splice.removed)) ? this : new Stage(materials, new NodeTree(tree, splice));
    }

    /** Whether both have the same names of shapes and groups, because the one was made of the other. */
    boolean sharesNames(Stage o) {
        return tree.names == o.tree.names;
    }

    /** Whether both have the same groups, and as many shapes in the same places of the tree, because the one was made of the other. */
    public boolean sharesStructure(Stage o) {
        return tree.structure == o.tree.structure;
    }

    /** Whether both have equal shapes and groups in the same order. Where one of them was edited this is known without a walk. */
    public boolean hasSameNodes(Stage o) {
        return tree == o.tree || tree.hash == o.tree.hash && nodes().equals(o.nodes());
    }

    /** All visible shapes, in the order of the file, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        List<PlacedShape> placed = new ArrayList<>(tree.shapeCount);
        forEachPlacedShape(placed::add);
        return placed;
    }

    /** Hands over the same, one after the other: a list of a million of them takes half a gigabyte. */
    public void forEachPlacedShape(Consumer<PlacedShape> consumer) {
        forEachPlacedShape(tree.nodes, Transform.IDENTITY, Transform.IDENTITY, PlacementError.NONE, consumer);
    }

    /** All visible shapes, in the order of the file, as they stand there. */
    public List<Shape> shapes() {
        return tree.shapes();
    }

    /**
     * Of each of the {@link #shapes} whether it is among those linked; not to be written to.
     *
     * @return {@code boolean[shapes().size()]}
     */
    public boolean[] linkMask(ShapeLinks links) {
        return tree.linkMask(links);
    }

    private void forEachPlacedShape(List<SceneNode> nodes, Transform outer, Transform outerInverse, PlacementError outerError,
            Consumer<PlacedShape> consumer) {
        for (SceneNode node : nodes) {
            if (!node.visible()) {
                continue;
            }
            Transform toWorld = outer.times(node.placement().transform());
            Transform directionsBack = node.placement().directionsToLocal().times(outerInverse);
            PlacementError error = outerError.compose(outer, outerInverse, node.placement());
            switch (node) {
                case NodeGroup g -> forEachPlacedShape(g.children(), toWorld, directionsBack, error, consumer);
                case Shape s -> consumer.accept(new PlacedShape(s, materialsByName.get(s.material()), toWorld, directionsBack, error));
            }
        }
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Stage s && hasSameNodes(s) && materials.equals(s.materials);
    }

    @Override
    public int hashCode() {
        return 31 * materials.hashCode() + Long.hashCode(tree.hash);
    }
}
