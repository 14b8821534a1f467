package lightning.editor.document;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.scene.Group;
import lightning.scene.Limits;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;

/** The edits of shapes and groups. Each is refused if there is none of the name given. */
public final class NodeEdits {
    /** Leaves room for a number in a name of the greatest length. */
    private static final int LONGEST_STEM = Limits.MAX_NAME - 7;
    /** More numbers than a scene has names. */
    private static final int NUMBERS = 1 << 22;

    private NodeEdits() {}

    private static Node node(Scene scene, String name) {
        return scene.stage().node(name).orElseThrow(() -> new IllegalArgumentException(Texts.of("there is no shape {0}", Quote.of(name))));
    }

    /** Any edit of one shape or group that keeps its name. */
    public static Change with(Scene scene, String name, UnaryOperator<Node> edit) {
        return Change.of(() -> scene.withNode(name, edit.apply(node(scene, name))));
    }

    /** Another place, turn or size. */
    public static Change placement(Scene scene, String name, UnaryOperator<Placement> edit) {
        return with(scene, name, n -> n.withPlacement(edit.apply(n.placement())));
    }

    public static Change visible(Scene scene, String name, boolean visible) {
        return with(scene, name, n -> n.withVisible(visible));
    }

    /** Takes a shape, or a group with all that is in it, out of the scene. */
    public static Change delete(Scene scene, String name) {
        return Change.of(() -> scene.replacing(node(scene, name).name(), List.of()));
    }

    /** Refused if the name is taken or could not stand in a scene file. */
    public static Change rename(Scene scene, String name, String newName) {
        return Change.of(() -> scene.replacing(name, List.of(switch (node(scene, name)) {
            case Group g -> new Group(newName, g.placement(), g.children(), g.visible());
            case Shape s -> s.withName(newName);
        })));
    }

    /** Puts a copy, with free names for it and all that is in it, behind a shape or a group and a little beside it. */
    public static Change duplicate(Scene scene, String name) {
        return Change.of(() -> {
            Node original = node(scene, name);
            Node copy = copy(original, scene, new HashSet<>());
            return scene.replacing(name, List.of(original, copy.withPlacement(beside(scene, copy.placement()))));
        });
    }

    /** The name that a copy of a shape or a group gets. */
    public static String copyOf(Scene scene, String name) {
        return freeName(scene, name, Set.of());
    }

    private static Placement beside(Scene scene, Placement original) {
        return new Placement(Beside.of(scene, original.at()), original.rotate(), original.scale());
    }

    private static Node copy(Node node, Scene scene, Set<String> given) {
        String name = freeName(scene, node.name(), given);
        given.add(name);
        return switch (node) {
            case Group g -> new Group(name, g.placement(), g.children().stream().map(n -> copy(n, scene, given)).toList(), g.visible());
            case Shape s -> s.withName(name);
        };
    }

    /**
     * A name that no light, shape or group has: the same with the next number behind it that is free. Where that and those after it are
     * taken, it is sought in strides that double, since a hundred thousand shapes may be numbered.
     *
     * @param given names that are about to be taken
     */
    static String freeName(Scene scene, String name, Set<String> given) {
        String stem = name.replaceFirst("\\d{1,6}$", "");
        String digits = name.substring(stem.length());
        String room = stem.codePointCount(0, stem.length()) <= LONGEST_STEM ? stem
                : stem.substring(0, stem.offsetByCodePoints(0, LONGEST_STEM));
        int taken = digits.isEmpty() ? 1 : Integer.parseInt(digits);
        int stride = 1;
        while (isTaken(scene, room + (taken + stride), given) && stride < NUMBERS) {
            stride *= 2;
        }
        int free = taken + stride;
        taken += stride / 2;
        while (free - taken > 1) {
            int middle = (free + taken) / 2;
            if (isTaken(scene, room + middle, given)) {
                taken = middle;
            } else {
                free = middle;
            }
        }
        return room + free;
    }

    private static boolean isTaken(Scene scene, String name, Set<String> given) {
        return scene.isTaken(name) || given.contains(name);
    }
}
