package lightning.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
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

    /** The groups around the shape or the group of that name, the outermost first; none where there is none of that name. */
    public List<Group> around(String name) {
        List<Group> groups = new ArrayList<>();
        around(nodes(), name, groups);
        return groups;
    }

    private static boolean around(List<Node> nodes, String name, List<Group> groups) {
        for (Node node : nodes) {
            if (node.name().equals(name)) {
                return true;
            }
            if (node instanceof Group g) {
                groups.add(g);
                if (around(g.children(), name, groups)) {
                    return true;
                }
                groups.removeLast();
            }
        }
        return false;
    }

    /**
     * This stage with a shape or a group in place of that name's; all other nodes are shared.
     *
     * @throws IllegalArgumentException as {@link #Stage(List, List)}
     */
    public Stage withNode(String name, Node node) {
        return replacing(name, List.of(node));
    }

    /**
     * This stage with none, one or several nodes in place of that name's; itself where there is none of that name. What is known of all
     * others serves on, so that it takes little time however many there are.
     *
     * @throws IllegalArgumentException as {@link #Stage(List, List)}
     */
    public Stage replacing(String name, List<? extends Node> by) {
        var splice = new Splice(name, by);
        List<Node> nodes = splice.in(nodes(), 0, 1, 1);
        return splice.old == null || by.equals(List.of(splice.old)) ? this : new Stage(materials, new Tree(tree, nodes, splice));
    }

    /** Nodes in place of one, and where that stands. */
    private static final class Splice {
        final String name;
        final List<? extends Node> by;
        /** The node that goes; null until it is found. */
        Node old;
        /** Of the groups around it: how many they are, and the products of their scales. */
        int nesting;
        double least;
        double most;

        Splice(String name, List<? extends Node> by) {
            this.name = name;
            this.by = by;
        }

        List<Node> in(List<Node> nodes, int outerNesting, double outerLeast, double outerMost) {
            for (int i = 0; i < nodes.size(); i++) {
                Node node = nodes.get(i);
                if (node.name().equals(name)) {
                    old = node;
                    nesting = outerNesting;
                    least = outerLeast;
                    most = outerMost;
                    return spliced(nodes, i, by);
                }
                if (node instanceof Group g) {
                    List<Node> children = in(g.children(), outerNesting + 1, outerLeast * g.placement().leastScale(),
                            outerMost * g.placement().mostScale());
                    if (old != null) {
                        return spliced(nodes, i, List.of(g.withChildren(children)));
                    }
                }
            }
            return nodes;
        }

        private static List<Node> spliced(List<Node> nodes, int at, List<? extends Node> by) {
            List<Node> all = new ArrayList<>(nodes.size() - 1 + by.size());
            all.addAll(nodes.subList(0, at));
            all.addAll(by);
            all.addAll(nodes.subList(at + 1, nodes.size()));
            return List.copyOf(all);
        }
    }

    /** Whether both have the same names of shapes and groups, because the one was made of the other. */
    boolean sharesNodesWith(Stage o) {
        return tree.names == o.tree.names;
    }

    /** Whether both have the same shapes and groups in the same places of the tree, because the one was made of the other. */
    public boolean sharesOutlineWith(Stage o) {
        return tree.outline == o.tree.outline;
    }

    /** Whether in both each shape has the same material, because the one was made of the other. */
    public boolean sharesUsersWith(Stage o) {
        return tree.users == o.tree.users;
    }

    /** All visible shapes, in the order of the file, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        List<PlacedShape> placed = new ArrayList<>(tree.count);
        place(placed::add);
        return placed;
    }

    /** Hands over the same, one after the other: a list of a million of them takes half a gigabyte. */
    public void place(Consumer<PlacedShape> to) {
        place(tree.nodes, Transform.IDENTITY, Transform.IDENTITY, PlacementError.NONE, to);
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
    public boolean[] linked(Links links) {
        return tree.linked(links);
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

    /** All that is in some nodes, checked for limits: in the order of the file. */
    private static final class Survey {
        final List<String> names = new ArrayList<>();
        final List<Shape> shapes = new ArrayList<>();

        Survey(List<? extends Node> nodes, int nesting, double leastScale, double mostScale) {
            take(nodes, nesting, leastScale, mostScale);
        }

        private void take(List<? extends Node> nodes, int nesting, double leastScale, double mostScale) {
            Limits.range("the nesting of groups", nesting, 0, Limits.MAX_NESTING);
            for (Node node : nodes) {
                names.add(node.name());
                double least = leastScale * node.placement().leastScale();
                double most = mostScale * node.placement().mostScale();
                Limits.combinedScale(() -> "shape " + Quote.of(node.name()), least, most);
                switch (node) {
                    case Group g -> take(g.children(), nesting + 1, least, most);
                    case Shape s -> shapes.add(s);
                }
            }
        }

        /** The names, sorted. */
        String[] sorted() {
            String[] all = names.toArray(String[]::new);
            Arrays.parallelSort(all);
            return all;
        }

        boolean hasSameUsers(Survey o) {
            boolean same = shapes.size() == o.shapes.size();
            for (int i = 0; same && i < shapes.size(); i++) {
                Shape a = shapes.get(i);
                Shape b = o.shapes.get(i);
                same = a.name().equals(b.name()) && a.material().equals(b.material());
            }
            return same;
        }
    }

    /** The nodes, checked, with what must be known of them when materials or lights change. */
    private static final class Tree {
        /** Of so many links it is kept which shapes they are. */
        private static final int MOST_LINKS = 64;

        final List<Node> nodes;
        /** Of all nodes, sorted: a table of hashes would be slow where a file chose names that collide. */
        final String[] names;
        /** How many shapes there are. */
        final int count;
        /** For each material in use the first shape that has it. */
        final Map<String, String> users;
        /** Stands for the names and their places in the tree, told by identity. */
        final Object outline;
        /** Found when it is asked for; whoever finds it finds the same. */
        private List<Shape> shapes;
        /** The shapes linked by what was asked last. */
        private final Map<Links, boolean[]> linked = new ConcurrentHashMap<>();

        static Tree of(List<Node> nodes) {
            return new Tree(List.copyOf(nodes));
        }

        private Tree(List<Node> nodes) {
            this.nodes = nodes;
            var all = new Survey(nodes, 0, 1, 1);
            count = Limits.range("the number of shapes", all.shapes.size(), 0, Limits.MAX_SHAPES);
            names = all.sorted();
            for (int i = 1; i < names.length; i++) {
                if (names[i].equals(names[i - 1])) {
                    throw taken(names[i]);
                }
            }
            users = users(all.shapes);
            outline = new Object();
        }

        /** Those of another with some in place of one. */
        private Tree(Tree before, List<Node> nodes, Splice splice) {
            this.nodes = nodes;
            var gone = new Survey(List.of(splice.old), splice.nesting, splice.least, splice.most);
            var came = new Survey(splice.by, splice.nesting, splice.least, splice.most);
            count = Limits.range("the number of shapes", before.count - gone.shapes.size() + came.shapes.size(), 0, Limits.MAX_SHAPES);
            names = gone.names.equals(came.names) ? before.names : merged(before.names, gone.sorted(), came.sorted());
            users = gone.hasSameUsers(came) ? before.users : users(new Survey(nodes, 0, 1, 1).shapes);
            outline = sameOutline(List.of(splice.old), splice.by) ? before.outline : new Object();
        }

        boolean[] linked(Links links) {
            if (linked.size() > MOST_LINKS) {
                linked.clear();
            }
            return linked.computeIfAbsent(links, asked -> {
                boolean[] found = new boolean[shapes().size()];
                mark(nodes, new HashSet<>(asked.names()), asked.only(), false, found, 0);
                return found;
            });
        }

        /** @return the place of the shape behind those of the nodes */
        private static int mark(List<Node> nodes, Set<String> names, boolean only, boolean named, boolean[] found, int from) {
            int at = from;
            for (Node node : nodes) {
                boolean here = named || names.contains(node.name());
                switch (node) {
                    case Group g when g.visible() -> at = mark(g.children(), names, only, here, found, at);
                    case Shape s when s.visible() -> found[at++] = here == only;
                    case Node _ -> {}
                }
            }
            return at;
        }

        private static boolean sameOutline(List<? extends Node> a, List<? extends Node> b) {
            boolean same = a.size() == b.size();
            for (int i = 0; same && i < a.size(); i++) {
                same = a.get(i) == b.get(i) || a.get(i).name().equals(b.get(i).name()) && switch (a.get(i)) {
                    case Group g -> b.get(i) instanceof Group h && sameOutline(g.children(), h.children());
                    case Shape _ -> b.get(i) instanceof Shape;
                };
            }
            return same;
        }

        private static String[] merged(String[] names, String[] gone, String[] came) {
            String[] all = new String[names.length - gone.length + came.length];
            int from = 0;
            int to = 0;
            int g = 0;
            int c = 0;
            while (g < gone.length || c < came.length) {
                // What goes first, so that a name that comes again is not found any more.
                boolean goes = c == came.length || g < gone.length && gone[g].compareTo(came[c]) <= 0;
                int found = Arrays.binarySearch(names, from, names.length, goes ? gone[g] : came[c]);
                int place = found < 0 ? -found - 1 : found;
                System.arraycopy(names, from, all, to, place - from);
                to += place - from;
                from = place;
                if (goes) {
                    from++;
                    g++;
                } else if (found >= 0 || c > 0 && came[c].equals(came[c - 1])) {
                    throw taken(came[c]);
                } else {
                    all[to++] = came[c++];
                }
            }
            System.arraycopy(names, from, all, to, names.length - from);
            return all;
        }

        private static IllegalArgumentException taken(String name) {
            return new IllegalArgumentException("shape " + Quote.of(name) + ": the name is already taken");
        }

        private static Map<String, String> users(List<Shape> shapes) {
            Map<String, String> users = new LinkedHashMap<>();
            shapes.forEach(s -> users.putIfAbsent(s.material(), s.name()));
            return users;
        }

        /** All visible shapes in the order of the file; the nodes themselves where none is a group or hidden. */
        List<Shape> shapes() {
            List<Shape> found = shapes;
            if (found == null) {
                found = count == names.length && nodes.stream().allMatch(Node::visible) ? allShapes(nodes)
                        : List.copyOf(collect(nodes, new ArrayList<>(count)));
                shapes = found;
            }
            return found;
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

        void checkMaterials(Set<String> known) {
            users.forEach((material, shape) -> {
                if (!known.contains(material)) {
                    throw new IllegalArgumentException("shape " + Quote.of(shape) + ": there is no material " + Quote.of(material));
                }
            });
        }
    }
}
