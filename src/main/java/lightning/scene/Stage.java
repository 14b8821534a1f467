package lightning.scene;

import static java.util.Objects.requireNonNull;

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
import lightning.base.text.RefusalException;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.light.ObjectSurface;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.NodeNames;
import lightning.scene.node.NodePaths;
import lightning.scene.node.NodeSplice;
import lightning.scene.node.NodeTree;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.PlacementError;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * Shapes and materials of a scene, with the tree of groups. Checked once at construction, and shared by all scenes that differ only in
 * lights or views. Stages are equal if their nodes and materials are; identical ones compare quickly.
 */
public final class Stage {
    /** Empty stage. */
    public static final Stage EMPTY = new Stage(List.of(), List.of());

    private final NodeTree tree;
    private final List<Material> materials;
    private final Map<String, Material> materialsByName;
    /** First material with the sharpest highlights; {@code null} if no light's term can exceed 1. */
    private final @Nullable Material sharpestMaterial;
    /** True if any material is a light's bulb. */
    private final boolean hasBulbs;
    /** Faces of the visible lights of the scene that contains this stage. */
    private final List<LightFace> faces;
    /** These shapes with earlier faces; null if unknown. */
    private final @Nullable NodeTree earlier;
    /** These shapes and materials with {@link #faces}, made on demand. */
    private volatile @Nullable Stage rendered;

    /**
     * @param materials materials with unique names
     * @param nodes     shapes and groups with unique names; each shape's material is one of {@code materials}, or {@code default}
     * @throws RefusalException if a name is taken or a material missing, if there are more shapes, materials or nested groups than
     *     {@link SceneLimits} allows, or if combined scales are out of range
     */
    public Stage(List<Material> materials, List<SceneNode> nodes) {
        this(materials, new NodeTree(nodes), List.of(), null);
    }

    /** @param earlier these shapes with earlier faces; null if unknown */
    private Stage(List<Material> materials, NodeTree tree, List<LightFace> faces, @Nullable NodeTree earlier) {
        this.faces = faces;
        this.earlier = earlier;
        this.materials = List.copyOf(materials);
        this.tree = tree;
        SceneLimits.checkRange("the number of materials", this.materials.size(), 0, SceneLimits.MAX_MATERIALS);
        Map<String, Material> materialMap = HashMap.newHashMap(this.materials.size() + 1);
        Material sharpest = null;
        for (Material material : this.materials) {
            sharpest = material.maxTerm() > (sharpest == null ? 1 : sharpest.maxTerm()) ? material : sharpest;
            if (materialMap.put(material.name(), material) != null) {
                throw new RefusalException("material " + Quote.of(material.name()) + ": the name is already taken");
            }
        }
        hasBulbs = this.materials.stream().anyMatch(m -> !m.bulb().light().isEmpty());
        materialMap.putIfAbsent(Material.DEFAULT.name(), Material.DEFAULT);
        materialsByName = Map.copyOf(materialMap);
        sharpestMaterial = sharpest;
        tree.materialUsers.check(materialsByName.keySet());
    }

    /** Returns these shapes with other materials. */
    public Stage withMaterials(List<Material> v) {
        return v.equals(materials) ? this : new Stage(v, tree, List.of(), knownFaces());
    }

    /** Returns this stage with the bulbs of a rig's lights as bright as the lights. */
    Stage withBulbs(LightRig rig) {
        return !hasBulbs ? this : withMaterials(materials.stream()
                .map(m -> m.bulb().light().isEmpty() || m.bulb().litBy(rig).equals(m.bulb()) ? m : m.withBulb(m.bulb().litBy(rig)))
                .toList());
    }

    /** Returns the surfaces of the shapes that are lights of a rig, hidden ones too, by the shapes' names. */
    Map<String, ObjectSurface> surfaces(LightRig rig) {
        Map<String, ObjectSurface> surfaces = new HashMap<>();
        for (Light light : rig.lights()) {
            if (light.type() == LightType.OBJECT && !light.area().shape().isEmpty()) {
                surface(light, rig).ifPresent(surface -> surfaces.put(light.area().shape(), surface));
            }
        }
        return surfaces.isEmpty() ? Map.of() : Map.copyOf(surfaces);
    }

    private Optional<ObjectSurface> surface(Light light, LightRig rig) {
        String name = light.area().shape();
        if (!(node(name).orElse(null) instanceof Shape shape)) {
            return Optional.empty();
        }
        Transform toScene = Transform.IDENTITY;
        for (NodeGroup group : enclosingGroups(name)) {
            toScene = toScene.times(group.placement().transform());
        }
        Transform place = toScene.times(shape.placement().transform());
        Material material = requireNonNull(materialsByName.get(shape.material()));
        Optional<TextureMap> image = material.bulb().light().equals(light.name()) ? material.glowMap() : Optional.empty();
        ObjectSurface known = rig.surface(name).orElse(null);
        return Optional.of(known != null && known.isOf(shape.solid(), place, image) ? known
                : new ObjectSurface(shape.solid(), place, image, known));
    }

    /** Returns this stage with the faces of a rig's visible lights. */
    Stage withFaces(LightRig rig) {
        List<LightFace> v = LightFace.of(rig, tree.shapeCount, materialsByName.keySet());
        return v.equals(faces) ? this : new Stage(materials, tree, v, v.isEmpty() ? null : knownFaces());
    }

    /**
     * Returns the shapes and materials that camera rays meet: these, followed by the faces of visible lights. A face has the name of its
     * light.
     */
    public Stage rendered() {
        if (faces.isEmpty()) {
            return this;
        }
        Stage made = rendered;
        if (made == null) {
            // A race between threads makes two equal stages.
            made = withFaceShapes(earlier);
            rendered = made;
        }
        return made;
    }

    /** Returns these shapes with the latest known faces; null for none. */
    private @Nullable NodeTree knownFaces() {
        return rendered == null ? earlier : rendered.tree;
    }

    /** Returns the names of the lights whose faces {@link #rendered} contains, in its order. */
    public List<String> faceNames() {
        return faces.stream().map(face -> face.shape().name()).toList();
    }

    /** @param known these shapes with faces, possibly of other lights */
    private Stage withFaceShapes(@Nullable NodeTree known) {
        List<Material> all = new ArrayList<>(materials);
        faces.forEach(face -> all.add(face.material()));
        List<Shape> shapes = faces.stream().map(LightFace::shape).toList();
        int count = nodes().size();
        if (known == null || known.nodes.size() != count + shapes.size()
                || !IntStream.range(0, shapes.size()).allMatch(i -> known.nodes.get(count + i).name().equals(shapes.get(i).name()))) {
            List<SceneNode> nodes = new ArrayList<>(nodes());
            nodes.addAll(shapes);
            return new Stage(all, nodes);
        }
        NodeTree updated = known;
        for (int i = 0; i < shapes.size(); i++) {
            int[] path = {count + i};
            var splice = new NodeSplice(updated.nodes, path, List.of(shapes.get(i)));
            updated = shapes.get(i).equals(splice.removed) ? updated : new NodeTree(updated, splice);
        }
        return new Stage(all, updated, List.of(), null);
    }

    /** Returns this stage with the bulbs of a light as those of its new name. */
    Stage renameBulbs(String light, String newName) {
        return !hasBulbs ? this : withMaterials(materials.stream()
                .map(m -> m.bulb().light().equals(light) ? m.withBulb(m.bulb().withLight(newName)) : m).toList());
    }

    /** Returns these materials with other shapes. */
    public Stage withNodes(List<SceneNode> v) {
        return v.equals(nodes()) ? this : new Stage(materials, new NodeTree(v), List.of(), null);
    }

    public List<Material> materials() {
        return materials;
    }

    public List<SceneNode> nodes() {
        return tree.nodes;
    }

    /** Returns every material that a shape may name, including {@code default}. */
    public Map<String, Material> materialsByName() {
        return materialsByName;
    }

    /** Returns the first material whose highlights amplify a light the most; empty if none amplifies it. */
    Optional<Material> sharpestMaterial() {
        return Optional.ofNullable(sharpestMaterial);
    }

    /** Returns the names of used materials, in the order of their first shapes, without a walk. */
    public Set<String> usedMaterials() {
        return tree.materialUsers.materials();
    }

    /** Returns the number of shapes, including those in groups and hidden ones. */
    public int shapeCount() {
        return tree.shapeCount;
    }

    /** Returns whether a shape or a group has the name. */
    public boolean hasNode(String name) {
        return tree.names.contains(name);
    }

    /** Returns the shape or the group of that name. */
    public Optional<SceneNode> node(String name) {
        return path(name).map(places -> NodePaths.nodeAt(nodes(), places));
    }

    /**
     * Returns the path of the shape or group of that name: child indices from the outermost group, at least one. Empty if it does not
     * exist.
     */
    public Optional<int[]> path(String name) {
        return hasNode(name) ? Optional.ofNullable(tree.paths.find(nodes(), name)) : Optional.empty();
    }

    /** Returns the groups that enclose the node of that name, the outermost first; empty if it does not exist. */
    public List<NodeGroup> enclosingGroups(String name) {
        int[] path = path(name).orElse(new int[1]);
        return IntStream.range(1, path.length).mapToObj(n -> (NodeGroup) NodePaths.nodeAt(nodes(), Arrays.copyOf(path, n))).toList();
    }

    /** Returns the number of nodes visited to look up names. */
    long visitedNodes() {
        return tree.paths.visitedCount();
    }

    /**
     * Returns this stage with the node of that name replaced by none, one or several; itself if the node does not exist. Reuses the data of
     * all other nodes, so that it takes little time in any scene.
     *
     * @throws RefusalException as {@link #Stage(List, List)}
     */
    public Stage replaceNode(String name, List<? extends SceneNode> replacement) {
        Optional<int[]> path = path(name);
        if (path.isEmpty()) {
            return this;
        }
        var splice = new NodeSplice(nodes(), path.get(), replacement);
        if (replacement.equals(List.of(splice.removed))) {
            return this;
        }
        var changed = new NodeTree(tree, splice);
        NodeTree known = knownFaces();
        // Drags of a shape keep its name, so that no face can have it.
        boolean canKeep = replacement.size() == 1 && replacement.getFirst() instanceof Shape s && s.name().equals(name);
        return new Stage(materials, changed, List.of(),
                known != null && canKeep ? new NodeTree(known, new NodeSplice(known.nodes, path.get(), replacement)) : null);
    }

    /** Returns the names of all shapes and groups. */
    NodeNames names() {
        return tree.names;
    }

    /** Returns whether both share their table of names, because one was made from the other. */
    boolean sharesNames(Stage o) {
        return tree.names == o.tree.names;
    }

    /** Returns whether both have the same groups, with as many shapes at the same paths, because one was made from the other. */
    public boolean sharesStructure(Stage o) {
        return tree.structure == o.tree.structure;
    }

    /** Returns whether both have equal shapes and groups in the same order. Needs no walk if one was made from the other. */
    public boolean hasSameNodes(Stage o) {
        return tree == o.tree || tree.hash == o.tree.hash && nodes().equals(o.nodes());
    }

    /** Returns all visible shapes, in file order, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        List<PlacedShape> placed = new ArrayList<>(tree.shapeCount);
        forEachPlacedShape(placed::add);
        return placed;
    }

    /** Passes each placed shape to a consumer, because a list of a million takes half a gigabyte. */
    public void forEachPlacedShape(Consumer<PlacedShape> consumer) {
        forEachPlacedShape(tree.nodes, Transform.IDENTITY, Transform.IDENTITY, PlacementError.NONE, consumer);
    }

    /** Returns all visible shapes, in file order, as they are in the tree. */
    public List<Shape> shapes() {
        return tree.shapes();
    }

    /**
     * Returns for each shape of the {@link #rendered} stage whether it is linked; read-only.
     *
     * @return {@code boolean[rendered().shapes().size()]}
     */
    public boolean[] linkMask(ShapeLinks links) {
        return rendered().tree.linkMask(links);
    }

    /**
     * Returns for each shape of the {@link #rendered} stage which gain applies to it: the position after that of its own name or that of its
     * innermost named group in {@code names}; 0 if none is named. Read-only.
     */
    public short[] gainEntries(List<String> names) {
        return rendered().tree.gainEntries(names);
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
                case Shape s -> consumer
                        .accept(new PlacedShape(s, requireNonNull(materialsByName.get(s.material())), toWorld, directionsBack, error));
            }
        }
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Stage s && hasSameNodes(s) && materials.equals(s.materials) && faces.equals(s.faces);
    }

    @Override
    public int hashCode() {
        return 31 * materials.hashCode() + Long.hashCode(tree.hash);
    }
}
