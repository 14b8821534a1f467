package lightning.document;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.document.manipulation.DuplicateOffset;
import lightning.scene.ObjectLight;
import lightning.scene.Scene;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Edits of shapes and groups. Each is refused if the named node does not exist. */
public final class NodeEdits {
    /** Leaves room for a number within the maximum name length. */
    private static final int MAX_STEM = SceneLimits.MAX_NAME - 7;
    /** Exceeds the number of names in any scene. */
    private static final int MAX_STRIDE = 1 << 22;

    private NodeEdits() {}

    private static SceneNode node(Scene scene, String name) {
        return scene.stage().node(name)
                .orElseThrow(() -> new RefusalException(Messages.tr("object {0} not found", Quote.of(name))));
    }

    /** Edits one shape or group, keeping its name. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<SceneNode> edit) {
        return EditOutcome.of(() -> scene.withNode(name, edit.apply(node(scene, name))));
    }

    /** Sets position, rotation and scale. */
    public static EditOutcome setPlacement(Scene scene, String name, UnaryOperator<Placement> edit) {
        return edit(scene, name, n -> n.withPlacement(edit.apply(n.placement())));
    }

    public static EditOutcome setVisible(Scene scene, String name, boolean visible) {
        return edit(scene, name, n -> n.withVisible(visible));
    }

    /** Deletes a shape, or a group with its content. */
    public static EditOutcome delete(Scene scene, String name) {
        return EditOutcome.of(() -> scene.replaceNode(node(scene, name).name(), List.of()));
    }

    /** Makes a shape a light as bright as its glow; refused for a group. @param light name of the new light */
    public static EditOutcome makeLight(Scene scene, String name, String light) {
        return EditOutcome.of(() -> {
            if (!(node(scene, name) instanceof Shape)) {
                throw new RefusalException(Messages.tr("{0} is a group; only an object can be a light", name));
            }
            return ObjectLight.make(scene, name, light);
        });
    }

    /** Renames a node; refused if the name is taken or invalid in a scene file. */
    public static EditOutcome rename(Scene scene, String name, String newName) {
        return EditOutcome.of(() -> scene.replaceNode(name, List.of(switch (node(scene, name)) {
            case NodeGroup g -> new NodeGroup(newName, g.placement(), g.children(), g.visible());
            case Shape s -> s.withName(newName);
        })));
    }

    /** Adds a copy of a node after it, with unique names and a small offset. */
    public static EditOutcome duplicate(Scene scene, String name) {
        return EditOutcome.of(() -> {
            SceneNode original = node(scene, name);
            SceneNode copy = copy(original, scene, new HashSet<>());
            return scene.replaceNode(name, List.of(original, copy.withPlacement(offset(scene, copy.placement()))));
        });
    }

    /** Returns the name of a node's next copy. */
    public static String copyName(Scene scene, String name) {
        return freeName(scene, name, Set.of());
    }

    private static Placement offset(Scene scene, Placement original) {
        return new Placement(DuplicateOffset.duplicatePosition(scene, original.position()), original.rotation(), original.scale());
    }

    private static SceneNode copy(SceneNode node, Scene scene, Set<String> newNames) {
        String name = freeName(scene, node.name(), newNames);
        newNames.add(name);
        return switch (node) {
            case NodeGroup g ->
                    new NodeGroup(name, g.placement(), g.children().stream().map(n -> copy(n, scene, newNames)).toList(), g.visible());
            case Shape s -> s.withName(name);
        };
    }

    /**
     * Returns the name with the next free number, unique among lights, shapes and groups. Searches taken numbers in doubling strides, as a
     * scene may have a hundred thousand numbered shapes.
     *
     * @param newNames names reserved for other new nodes
     */
    static String freeName(Scene scene, String name, Set<String> newNames) {
        String stem = name.replaceFirst("\\d{1,6}$", "");
        String digits = name.substring(stem.length());
        String shortStem = stem.codePointCount(0, stem.length()) <= MAX_STEM ? stem
                : stem.substring(0, stem.offsetByCodePoints(0, MAX_STEM));
        int takenNumber = digits.isEmpty() ? 1 : Integer.parseInt(digits);
        int stride = 1;
        while (isTaken(scene, shortStem + (takenNumber + stride), newNames) && stride < MAX_STRIDE) {
            stride *= 2;
        }
        int freeNumber = takenNumber + stride;
        takenNumber += stride / 2;
        while (freeNumber - takenNumber > 1) {
            int middle = (freeNumber + takenNumber) / 2;
            if (isTaken(scene, shortStem + middle, newNames)) {
                takenNumber = middle;
            } else {
                freeNumber = middle;
            }
        }
        return shortStem + freeNumber;
    }

    private static boolean isTaken(Scene scene, String name, Set<String> newNames) {
        return scene.isNameUsed(name) || newNames.contains(name);
    }
}
