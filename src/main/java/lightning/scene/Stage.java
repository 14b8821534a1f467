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
import java.util.stream.IntStream;
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
    /** Of those with the sharpest highlights the first; {@code null} where no light's term can be above 1. */
    private final Material glossiest;

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
        Material sharpest = null;
        for (Material material : this.materials) {
            sharpest = material.mostTerm() > (sharpest == null ? 1 : sharpest.mostTerm()) ? material : sharpest;
            if (found.put(material.name(), material) != null) {
                throw new IllegalArgumentException("material " + Quote.of(material.name()) + ": the name is already taken");
            }
        }
        found.putIfAbsent(Material.DEFAULT.name(), Material.DEFAULT);
        byName = Map.copyOf(found);
        glossiest = sharpest;
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

    /** The material whose highlights multiply a light the most, of several the first; empty where none makes it brighter than it is. */
    Optional<Material> glossiest() {
        return Optional.ofNullable(glossiest);
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
        return places(name).map(places -> NodePlaces.at(nodes(), places));
    }

    /**
     * Where the shape or the group of that name stands: its places in the groups around it, the outermost first, and in the innermost; at
     * least one. Empty where there is none.
     */
    public Optional<int[]> places(String name) {
        return hasNode(name) ? Optional.of(tree.places.of(nodes(), name)) : Optional.empty();
    }

    /** The groups around the shape or the group of that name, the outermost first; none where there is none of that name. */
    public List<Group> around(String name) {
        int[] places = places(name).orElse(new int[1]);
        return IntStream.range(1, places.length).mapToObj(n -> (Group) NodePlaces.at(nodes(), Arrays.copyOf(places, n))).toList();
    }

    /** How many nodes were looked at to find some by their names. */
    long looked() {
        return tree.places.looked();
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
        Optional<int[]> places = places(name);
        if (places.isEmpty()) {
            return this;
        }
        var splice = new Splice(places.get(), by);
        List<Node> nodes = splice.in(nodes(), 0, 1, 1);
        return by.equals(List.of(splice.old)) ? this : new Stage(materials, new Tree(tree, nodes, splice));
    }

    /** Nodes in place of one. */
    private static final class Splice {
        final int[] places;
        final List<? extends Node> by;
        /** The node that goes. */
        Node old;
        /** The products of the scales of the groups around it. */
        double least;
        double most;

        /** @param places where the node stands that goes */
        Splice(int[] places, List<? extends Node> by) {
            this.places = places;
            this.by = by;
        }

        int nesting() {
            return places.length - 1;
        }

        List<Node> in(List<Node> nodes, int depth, double outerLeast, double outerMost) {
            int place = places[depth];
            Node node = nodes.get(place);
            if (depth == nesting()) {
                old = node;
                least = outerLeast;
                most = outerMost;
                return spliced(nodes, place, by);
            }
            var group = (Group) node;
            return spliced(nodes, place, List.of(group.withChildren(in(group.children(), depth + 1,
                    outerLeast * group.placement().leastScale(), outerMost * group.placement().mostScale()))));
        }

        @SuppressWarnings("unchecked")
        private static List<Node> spliced(List<Node> nodes, int at, List<? extends Node> by) {
            // As objects: each of a hundred thousand nodes would be asked for its type.
            Object[] all = nodes.toArray();
            if (by.size() == 1) {
                all[at] = by.getFirst();
            } else {
                Object[] before = all;
                all = new Object[before.length - 1 + by.size()];
                System.arraycopy(before, 0, all, 0, at);
                System.arraycopy(by.toArray(), 0, all, at, by.size());
                System.arraycopy(before, at + 1, all, at + by.size(), before.length - 1 - at);
            }
            return (List<Node>) (List<?>) List.of(all);
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

    /** Whether both have equal shapes and groups in the same order. Where one of them was edited this is known without a walk. */
    boolean hasNodesOf(Stage o) {
        return tree == o.tree || tree.hash == o.tree.hash && nodes().equals(o.nodes());
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
        return this == o || o instanceof Stage s && hasNodesOf(s) && materials.equals(s.materials);
    }

    @Override
    public int hashCode() {
        return 31 * materials.hashCode() + Long.hashCode(tree.hash);
    }

    /** All that is in some nodes, checked for limits: in the order of the file. */
    private static final class Survey {
        final List<String> names = new ArrayList<>();
        final List<Shape> shapes = new ArrayList<>();
        /** How many shapes and groups are not visible by themselves. */
        int hidden;
        /** A sum over the nodes, each by itself. */
        long hash;

        Survey(List<? extends Node> nodes, int nesting, double leastScale, double mostScale) {
            take(nodes, nesting, leastScale, mostScale);
        }

        private void take(List<? extends Node> nodes, int nesting, double leastScale, double mostScale) {
            Limits.range("the nesting of groups", nesting, 0, Limits.MAX_NESTING);
            for (Node node : nodes) {
                names.add(node.name());
                hidden += node.visible() ? 0 : 1;
                double least = leastScale * node.placement().leastScale();
                double most = mostScale * node.placement().mostScale();
                Limits.combinedScale(() -> "shape " + Quote.of(node.name()), least, most);
                switch (node) {
                    case Group g -> {
                        hash += spread(31 * g.name().hashCode() + g.placement().hashCode(), g.visible());
                        take(g.children(), nesting + 1, least, most);
                    }
                    case Shape s -> {
                        hash += spread(s.hashCode(), true);
                        shapes.add(s);
                    }
                }
            }
        }

        /** So that sums of few bits tell nodes apart. */
        private static long spread(int hash, boolean visible) {
            long mixed = (hash * 2L + (visible ? 1 : 0)) * 0x9E3779B97F4A7C15L;
            return (mixed ^ mixed >>> 32) * 0xD6E8FEB86659FD93L;
        }

        /** The names, sorted. */
        String[] sorted() {
            String[] all = names.toArray(String[]::new);
            Arrays.parallelSort(all);
            return all;
        }

        /** For each material of the shapes the first that has it. */
        Map<String, String> users() {
            Map<String, String> users = new LinkedHashMap<>();
            shapes.forEach(s -> users.putIfAbsent(s.material(), s.name()));
            return users;
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
        /** How many shapes and groups are not visible by themselves. */
        private final int hidden;
        /** For each material in use the first shape that has it. */
        final Map<String, String> users;
        /** Stands for the names and their places in the tree, told by identity. */
        final Object outline;
        /** Equal for equal nodes. */
        final long hash;
        final NodePlaces places;
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
            users = all.users();
            hidden = all.hidden;
            outline = new Object();
            hash = all.hash;
            places = new NodePlaces();
        }

        /** Those of another with some in place of one. */
        private Tree(Tree before, List<Node> nodes, Splice splice) {
            this.nodes = nodes;
            var gone = new Survey(List.of(splice.old), splice.nesting(), splice.least, splice.most);
            var came = new Survey(splice.by, splice.nesting(), splice.least, splice.most);
            count = Limits.range("the number of shapes", before.count - gone.shapes.size() + came.shapes.size(), 0, Limits.MAX_SHAPES);
            names = gone.names.equals(came.names) ? before.names : merged(before.names, gone.sorted(), came.sorted());
            Map<String, String> known = users(before.users, gone.users(), came.users());
            users = known != null ? known : new Survey(nodes, 0, 1, 1).users();
            hidden = before.hidden - gone.hidden + came.hidden;
            outline = sameOutline(List.of(splice.old), splice.by) ? before.outline : new Object();
            hash = before.hash - gone.hash + came.hash;
            places = new NodePlaces(splice.places);
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

        /**
         * The users of all shapes where some came in the place of others; null where only a walk tells. Of a material that shapes came
         * with, and went with, the first of all stands before them, or among them.
         */
        private static Map<String, String> users(Map<String, String> all, Map<String, String> gone, Map<String, String> came) {
            Map<String, String> users = new LinkedHashMap<>(all);
            int first = 0;
            for (Map.Entry<String, String> user : gone.entrySet()) {
                if (all.get(user.getKey()).equals(user.getValue())) {
                    String next = came.get(user.getKey());
                    if (next == null) {
                        return null;
                    }
                    first++;
                    users.put(user.getKey(), next);
                }
            }
            boolean ordered = first < 2 || List.copyOf(gone.keySet()).equals(List.copyOf(came.keySet()));
            return ordered && gone.keySet().containsAll(came.keySet()) ? users : null;
        }

        /** All visible shapes in the order of the file; the nodes themselves where none is a group or hidden. */
        List<Shape> shapes() {
            List<Shape> found = shapes;
            if (found == null) {
                found = count == names.length && hidden == 0 ? allShapes(nodes)
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
