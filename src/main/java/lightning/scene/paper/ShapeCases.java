package lightning.scene.paper;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/** Edits of shapes, which are not in the paper, near the camera's target. Planes are skipped, as they are usually floors and walls. */
public final class ShapeCases {
    private final List<PaperCase> cases = new ArrayList<>();
    private final Scene scene;

    private ShapeCases(Scene scene) {
        this.scene = scene;
    }

    /** @param value 0 to {@link PaperCases#VALUES} − 1 for the first, second or third nearest shape; no cases if there are fewer */
    public static List<PaperCase> of(Scene scene, int value) {
        var builder = new ShapeCases(scene);
        CameraFraming framing = CameraFraming.of(scene.camera());
        scene.placedShapes().stream().filter(shape -> !(shape.shape().solid() instanceof Solid.Plane))
                .sorted(Comparator.comparingDouble(shape -> center(shape).minus(framing.focus()).length())).skip(value).findFirst()
                .ifPresent(shape -> builder.addEdits(shape.shape(), framing.extent() / 10));
        return builder.cases;
    }

    private static Vec3 center(PlacedShape shape) {
        return shape.toWorld().transformPoint(Vec3.ZERO);
    }

    /** @param step distance of the movement */
    private void addEdits(Shape shape, double step) {
        Placement p = shape.placement();
        add("shape-moved", withPlacement(shape, new Placement(p.position().plus(new Vec3(step, 0, 0)), p.rotation(), p.scale())));
        add("shape-turned", withPlacement(shape, new Placement(p.position(), p.rotation().plus(new Vec3(0, 15, 0)), p.scale())));
        add("shape-scaled", withPlacement(shape, new Placement(p.position(), p.rotation(), p.scale().times(0.8))));
        Scene hidden = scene.withNode(shape.name(), shape.withVisible(false));
        add("shape-hidden", hidden);
        add("shape-shown", hidden, scene);
    }

    private Scene withPlacement(Shape shape, Placement placement) {
        return scene.withNode(shape.name(), shape.withPlacement(placement));
    }

    private void add(String name, Scene... steps) {
        cases.add(PaperCase.unprinted(name, scene, steps));
    }
}
