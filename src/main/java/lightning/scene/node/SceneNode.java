package lightning.scene.node;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.base.text.NumberUnit;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Node of the scene tree: a shape, or a group of nodes. */
public sealed interface SceneNode permits Shape, NodeGroup {
    SceneAttribute<SceneNode, Vec3> AT = new SceneAttribute<>("at", "position", NumericKind.position(), Vec3.ZERO, "scene units",
            n -> n.placement().position(), (n, v) -> n.withPlacement(n.placement().withPosition(v)));
    SceneAttribute<SceneNode, Vec3> ROTATE = new SceneAttribute<>("rotate", "rotation",
            NumericKind.axes(SceneLimits.MAX_ROTATION, 5, NumberUnit.DEGREES, (_, v) -> Placement.IDENTITY.withRotation(v)), Vec3.ZERO,
            "degrees about x, then y, then z", n -> n.placement().rotation(), (n, v) -> n.withPlacement(n.placement().withRotation(v)));
    SceneAttribute<SceneNode, Vec3> SCALE = new SceneAttribute<>("scale", "scale",
            NumericKind.axes(SceneLimits.MAX_SCALE, 0.1, NumberUnit.FACTOR, (_, v) -> Placement.IDENTITY.withScale(v)), Vec3.ONE,
            "factors, none 0", n -> n.placement().scale(), (n, v) -> n.withPlacement(n.placement().withScale(v)));
    SceneAttribute<SceneNode, Boolean> VISIBLE =
            new SceneAttribute<>("visible", "visible", ChoiceKind.YES_OR_NO, true, "", SceneNode::visible, SceneNode::withVisible);

    /** Common attributes of shapes and groups, in file order. */
    List<SceneAttribute<SceneNode, ?>> ATTRIBUTES = List.of(AT, ROTATE, SCALE, VISIBLE);

    /** Unique name among all shapes, groups and lights. */
    String name();

    Placement placement();

    /** Returns whether it is visible; a hidden group hides its children. */
    boolean visible();

    SceneNode withPlacement(Placement v);

    SceneNode withVisible(boolean v);

    /** Returns all attributes with numbers or words; those of a shape's solid come first. */
    default List<SceneAttribute<SceneNode, ?>> attributes() {
        return this instanceof Shape s && s.solid() instanceof Solid.Canonical solid && !solid.attributes().isEmpty()
                ? Stream.<SceneAttribute<SceneNode, ?>>concat(solid.attributes().stream().map(Shape::attribute), ATTRIBUTES.stream())
                        .toList()
                : ATTRIBUTES;
    }
}
