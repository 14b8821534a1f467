package lightning.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.light.Light;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/**
 * Table of the links between lights and objects: a row for each shape and group, a column for each light.
 *
 * @param lights the scene's lights
 * @param rows   shapes and groups, each group before its contents
 * @param isCut  true if there are more objects than rows
 */
public record LinkTable(List<Light> lights, List<Row> rows, boolean isCut) {
    /** Maximum number of rows. */
    public static final int MAX_ROWS = 10_000;

    /**
     * Shape or group.
     *
     * @param path  names of its groups, the outermost first, and its own name last
     * @param node  the shape or group
     * @param isOpen true if the rows of a group's contents follow
     */
    public record Row(List<String> path, SceneNode node, boolean isOpen) {
        public String name() {
            return node.name();
        }

        public boolean isGroup() {
            return node instanceof NodeGroup;
        }

        /** Returns the number of enclosing groups. */
        public int depth() {
            return path.size() - 1;
        }
    }

    /** State of a link; that of a group includes all its contents. */
    public enum State {
        ON, OFF, MIXED
    }

    /**
     * Link between a light and an object.
     *
     * @param gain  gain of the light on the object
     * @param isOwn true if the object itself has the gain, false if its group has it or it is 1
     * @param hasOthers true if objects in the group have gains of their own
     */
    public record Link(State state, double gain, boolean isOwn, boolean hasOthers) {
        /** Describes the link for the user: {@code off}, {@code 30 %}, {@code 30 %, from its group}. */
        public String describe() {
            String gained = ShapeGains.formatPercent(gain) + (isOwn || gain == 1 ? "" : Messages.tr(", from its group"))
                    + (hasOthers ? Messages.tr(", other gains inside") : "");
            return switch (state) {
                case ON -> gained;
                case OFF -> Messages.tr("not linked");
                case MIXED -> Messages.tr("partly linked") + ", " + gained;
            };
        }
    }

    /**
     * Returns the table of a scene.
     *
     * @param closed names of groups whose contents have no rows
     * @param filter part of a name, in any case; if it is not empty, only objects with it have rows, in closed groups too
     */
    public static LinkTable of(Scene scene, Set<String> closed, String filter) {
        List<Row> rows = new ArrayList<>();
        String part = filter.strip().toLowerCase(Locale.ROOT);
        addRows(scene.nodes(), List.of(), closed, part, rows);
        boolean isCut = rows.size() > MAX_ROWS;
        return new LinkTable(scene.lights(), List.copyOf(isCut ? rows.subList(0, MAX_ROWS) : rows), isCut);
    }

    private static void addRows(List<SceneNode> nodes, List<String> groups, Set<String> closed, String filter, List<Row> rows) {
        for (SceneNode node : nodes) {
            if (rows.size() > MAX_ROWS) {
                return;
            }
            List<String> path = Stream.concat(groups.stream(), Stream.of(node.name())).toList();
            boolean isOpen = !filter.isEmpty() || !closed.contains(node.name());
            if (filter.isEmpty() || node.name().toLowerCase(Locale.ROOT).contains(filter)) {
                rows.add(new Row(path, node, isOpen && filter.isEmpty()));
            }
            if (isOpen && node instanceof NodeGroup group) {
                addRows(group.children(), path, closed, filter, rows);
            }
        }
    }

    /** Returns the link between a light and the object of a row. */
    public static Link link(Light light, Row row) {
        ShapeGains gains = light.influence().gains();
        Set<String> gained = gains.isNone() ? Set.of() : new HashSet<>(gains.names());
        return new Link(state(light.illuminates(), row), gain(gains, row.path()), gained.contains(row.name()),
                row.node() instanceof NodeGroup group && !gained.isEmpty() && containsAny(group, gained));
    }

    private static boolean containsAny(NodeGroup group, Set<String> names) {
        return group.children().stream()
                .anyMatch(n -> names.contains(n.name()) || n instanceof NodeGroup inner && containsAny(inner, names));
    }

    private static State state(ShapeLinks links, Row row) {
        boolean named = row.path().stream().anyMatch(links.names()::contains);
        State own = named == links.exclusive() ? State.ON : State.OFF;
        return named || links.names().isEmpty() || !(row.node() instanceof NodeGroup group) ? own
                : state(group, new HashSet<>(links.names()), links.exclusive());
    }

    /** Returns the state of a group whose own name and groups are not named. */
    private static State state(NodeGroup group, Set<String> names, boolean exclusive) {
        State all = null;
        for (SceneNode child : group.children()) {
            State one = names.contains(child.name()) == exclusive ? State.ON : State.OFF;
            if (!names.contains(child.name()) && child instanceof NodeGroup inner) {
                one = state(inner, names, exclusive);
            }
            all = all == null || all == one ? one : State.MIXED;
        }
        return all == null ? exclusive ? State.OFF : State.ON : all;
    }

    /** Returns the gain on an object: its own, or that of the innermost group that has one. */
    static double gain(ShapeGains gains, List<String> path) {
        return path.reversed().stream().map(gains::get).flatMap(Optional::stream).findFirst().orElse(1.0);
    }

    /** Returns the names of a node's groups and its own. */
    static List<String> path(Stage stage, String node) {
        return Stream.concat(stage.enclosingGroups(node).stream().map(NodeGroup::name), Stream.of(node)).toList();
    }
}
