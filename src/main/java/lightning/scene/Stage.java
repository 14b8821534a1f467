package lightning.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import lightning.math.Transform;
import lightning.text.Quote;

/**
 * What stands before the camera: shapes, in groups, and their materials. Checked once, when it is made, and shared by all
 * scenes that differ in lights or views only. Two stages are equal when their nodes and materials are; the same one is
 * known at once.
 */
public final class Stage {
    /** Nothing at all. */
    public static final Stage EMPTY = new Stage(List.of(), List.of());

    private final Tree tree;
    private final List<Material> materials;
    private final Map<String, Material> byName;

    /**
     * @param materials names unique among themselves
     * @param nodes     shapes and groups, names unique; each shape's material is the name of one of {@code materials}, or
     *                  {@code default} where none has that name
     * @throws IllegalArgumentException if a name is taken or a material missing, if there are more shapes, materials or
     *                                  nested groups than {@link Limits} allows, or if scales multiply beyond its range
     */
    public Stage(List<Material> materials, List<Node> nodes) {
        this(materials, Tree.of(nodes));
    }

    private Stage(List<Material> materials, Tree tree) {
        this.materials = List.copyOf(materials);
        this.tree = tree;
        Limits.range("the number of materials", this.materials.size(), 0, Limits.MAX_MATERIALS);
        Map<String, Material> found = HashMap.newHashMap(this.materials.size() + 1);
        for (Material material : this.materials) {
            if (found.put(material.name(), material) != null) {
                throw new IllegalArgumentException("material " + Quote.of(material.name()) + ": the name is already taken");
            }
        }
        found.putIfAbsent(Material.DEFAULT.name(), Material.DEFAULT);
        byName = Map.copyOf(found);
        tree.checkMaterials(byName.keySet());
    }

    /** These shapes with other materials. */
    public Stage withMaterials(List<Material> v) {
        return v.equals(materials) ? this : new Stage(v, tree);
    }

    /** These materials on other shapes. */
    public Stage withNodes(List<Node> v) {
        return v.equals(nodes()) ? this : new Stage(materials, Tree.of(v));
    }

    public List<Material> materials() {
        return materials;
    }

    public List<Node> nodes() {
        return tree.nodes;
    }

    /** Every material that a shape may name, {@code default} included. */
    public Map<String, Material> materialsByName() {
        return byName;
    }

    /** The names of the materials that shapes have, in the order of the first shapes that have them; nothing is walked. */
    public Set<String> namedMaterials() {
        return Collections.unmodifiableSet(tree.users.keySet());
    }

    /** How many shapes there are, those in groups and those that are not visible included. */
    public int shapeCount() {
        return tree.count;
    }

    /** Whether a shape or a group has the name. */
    public boolean hasNode(String name) {
        return Arrays.binarySearch(tree.names, name) >= 0;
    }

    /** The shape or the group of that name. */
    public Optional<Node> node(String name) {
        return hasNode(name) ? Optional.of(node(nodes(), name)) : Optional.empty();
    }

    private static Node node(List<Node> nodes, String name) {
        for (Node node : nodes) {
            Node found = node.name().equals(name) ? node : node instanceof Group g ? node(g.children(), name) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    /**
     * This stage with a shape or a group in place of that name's; all other nodes are shared.
     *
     * @throws IllegalArgumentException as {@link #Stage(List, List)}
     */
    public Stage withNode(String name, Node node) {
        return withNodes(with(nodes(), name, node));
    }

    private static List<Node> with(List<Node> nodes, String name, Node node) {
        List<Node> all = new ArrayList<>(nodes.size());
        boolean same = true;
        for (Node old : nodes) {
            Node now = old;
            if (old.name().equals(name)) {
                now = node;
            } else if (old instanceof Group g) {
                List<Node> children = with(g.children(), name, node);
                now = children == g.children() ? g : g.withChildren(children);
            }
            same &= now == old;
            all.add(now);
        }
        return same ? nodes : all;
    }

    /** Whether both have the same names of shapes and groups, because the one was made of the other. */
    boolean sharesNodesWith(Stage o) {
        return tree == o.tree;
    }

    /** All visible shapes, in the order of the file, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        List<PlacedShape> placed = new ArrayList<>(tree.shapes.size());
        place(placed::add);
        return placed;
    }

    /** Hands over the same, one after the other: a list of a million of them takes half a gigabyte. */
    public void place(Consumer<PlacedShape> to) {
        place(tree.nodes, Transform.IDENTITY, Transform.IDENTITY, PlacementError.NONE, to);
    }

    /** All visible shapes, in the order of the file, as they stand there. */
    public List<Shape> shapes() {
        return tree.shapes;
    }

    private void place(List<Node> nodes, Transform outer, Transform back, PlacementError outerError, Consumer<PlacedShape> to) {
        for (Node node : nodes) {
            if (!node.visible()) {
                continue;
            }
            Transform toWorld = outer.times(node.placement().transform());
            Transform directionsBack = node.placement().directionsBack().times(back);
            PlacementError error = outerError.within(outer, back, node.placement());
            switch (node) {
                case Group g -> place(g.children(), toWorld, directionsBack, error, to);
                case Shape s -> to.accept(new PlacedShape(s, byName.get(s.material()), toWorld, directionsBack, error));
            }
        }
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Stage s && materials.equals(s.materials) && tree.nodes.equals(s.tree.nodes);
    }

    @Override
    public int hashCode() {
        return 31 * materials.hashCode() + tree.nodes.hashCode();
    }

    /** The nodes, checked, with what must be known of them when materials or lights change. */
    private static final class Tree {
        final List<Node> nodes;
        /** Of all nodes, sorted: a table of hashes would be slow where a file chose names that collide. */
        final String[] names;
        /** All visible shapes in the order of the file; the nodes themselves where none is a group or hidden. */
        final List<Shape> shapes;
        /** How many shapes there are. */
        final int count;
        /** For each material in use the first shape that has it. */
        private final Map<String, String> users = new LinkedHashMap<>();

        static Tree of(List<Node> nodes) {
            return new Tree(List.copyOf(nodes));
        }

        private Tree(List<Node> nodes) {
            this.nodes = nodes;
            List<String> found = new ArrayList<>();
            count = Limits.range("the number of shapes", check(nodes, found, 0, 1, 1), 0, Limits.MAX_SHAPES);
            names = found.toArray(String[]::new);
            Arrays.parallelSort(names);
            for (int i = 1; i < names.length; i++) {
                if (names[i].equals(names[i - 1])) {
                    throw new IllegalArgumentException("shape " + Quote.of(names[i]) + ": the name is already taken");
                }
            }
            shapes = count == names.length && nodes.stream().allMatch(Node::visible) ? allShapes(nodes)
                    : List.copyOf(collect(nodes, new ArrayList<>(count)));
        }

        /** Nobody writes to the list: it is immutable. */
        @SuppressWarnings("unchecked")
        private static List<Shape> allShapes(List<? extends Node> nodes) {
            return (List<Shape>) nodes;
        }

        private static List<Shape> collect(List<Node> nodes, List<Shape> shapes) {
            for (Node node : nodes) {
                switch (node) {
                    case Group g when g.visible() -> collect(g.children(), shapes);
                    case Shape s when s.visible() -> shapes.add(s);
                    case Node _ -> {}
                }
            }
            return shapes;
        }

        /** Returns how many shapes there are. */
        private int check(List<Node> nodes, List<String> found, int nesting, double leastScale, double mostScale) {
            Limits.range("the nesting of groups", nesting, 0, Limits.MAX_NESTING);
            int count = 0;
            for (Node node : nodes) {
                found.add(node.name());
                double least = leastScale * node.placement().leastScale();
                double most = mostScale * node.placement().mostScale();
                Limits.combinedScale(() -> "shape " + Quote.of(node.name()), least, most);
                switch (node) {
                    case Group g -> count += check(g.children(), found, nesting + 1, least, most);
                    case Shape s -> {
                        users.putIfAbsent(s.material(), s.name());
                        count++;
                    }
                }
            }
            return count;
        }

        void checkMaterials(Set<String> known) {
            users.forEach((material, shape) -> {
                if (!known.contains(material)) {
                    throw new IllegalArgumentException("shape " + Quote.of(shape) + ": there is no material " + Quote.of(material));
                }
            });
        }
    }
}
