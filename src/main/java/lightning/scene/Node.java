package lightning.scene;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.base.text.Measure;

/** One entry of the scene's tree: a shape, or a group that places several nodes together. */
public sealed interface Node permits Shape, Group {
    Attribute<Node, Vec3> AT = new Attribute<>("at", "position", Quantity.position(), Vec3.ZERO, "scene units",
            n -> n.placement().at(), (n, v) -> n.withPlacement(n.placement().withAt(v)));
    Attribute<Node, Vec3> ROTATE = new Attribute<>("rotate", "rotation",
            Quantity.axes(Limits.MAX_ROTATION, 1, Measure.DEGREES, (_, v) -> Placement.IDENTITY.withRotate(v)), Vec3.ZERO,
            "degrees about x, then y, then z", n -> n.placement().rotate(), (n, v) -> n.withPlacement(n.placement().withRotate(v)));
    Attribute<Node, Vec3> SCALE = new Attribute<>("scale", "scale",
            Quantity.axes(Limits.MAX_SCALE, 0.1, Measure.FACTOR, (_, v) -> Placement.IDENTITY.withScale(v)), Vec3.ONE,
            "factors, none 0", n -> n.placement().scale(), (n, v) -> n.withPlacement(n.placement().withScale(v)));
    Attribute<Node, Boolean> VISIBLE = new Attribute<>("visible", "visible", Choice.YES_OR_NO, true, "", Node::visible, Node::withVisible);

    /** Those that shapes and groups have, in the order in which a file writes them. */
    List<Attribute<Node, ?>> ATTRIBUTES = List.of(AT, ROTATE, SCALE, VISIBLE);

    /** Unique among all shapes, groups and lights. */
    String name();

    Placement placement();

    /** Whether it is there at all; what is in a group that is not is not either. */
    boolean visible();

    Node withPlacement(Placement v);

    Node withVisible(boolean v);

    /** All that can be said of it by numbers and words: of a shape those of its solid first. */
    default List<Attribute<Node, ?>> attributes() {
        return this instanceof Shape s && s.solid() instanceof Solid.Canonical solid && !solid.attributes().isEmpty()
                ? Stream.<Attribute<Node, ?>>concat(solid.attributes().stream().map(Shape::attribute), ATTRIBUTES.stream()).toList()
                : ATTRIBUTES;
    }
}
