package lightning.layer;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfaceLocation;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Stage;

/**
 * Moves of an image's points from its frame to another one: by the camera, and by the placements of shapes and of the faces of lights. A
 * point of a shape that the other frame does not show stays where it is.
 */
final class MotionVectors {
    private final Scene scene;
    private final Scene other;
    private final PixelRays rays;
    private final PixelRays otherRays;
    /** Maps from shapes that move to the other frame's scene, by index in the rendered stage. */
    private final Map<Integer, Transform> moved;

    MotionVectors(Scene scene, Scene other) {
        this.scene = scene;
        this.other = other;
        rays = new PixelRays(scene);
        otherRays = new PixelRays(other);
        moved = scene.stage().rendered().equals(other.stage().rendered()) ? Map.of() : moved(scene.stage(), other.stage());
    }

    /** Compares placements by name: a shape and a light never have the same one. */
    private static Map<Integer, Transform> moved(Stage stage, Stage other) {
        Map<String, Transform> places = new HashMap<>();
        forEach(other, (_, shape) -> places.put(shape.shape().name(), shape.toWorld()));
        Map<Integer, Transform> result = new HashMap<>();
        forEach(stage, (index, shape) -> {
            Transform place = places.get(shape.shape().name());
            if (place != null && !place.equals(shape.toWorld())) {
                result.put(index, place);
            }
        });
        return result;
    }

    private interface PlacedShapeVisitor {
        void visit(int index, PlacedShape shape);
    }

    private static void forEach(Stage stage, PlacedShapeVisitor visitor) {
        int[] next = {0};
        stage.rendered().forEachPlacedShape(shape -> visitor.visit(next[0]++, shape));
    }

    /**
     * Returns the place of a surface point in the other frame minus that in this one, pixels to the right and down; 0 if the camera of the
     * other frame has it behind itself.
     *
     * @param owner index of its shape in the rendered stage
     * @param point the same point in scene coordinates
     */
    double[] ofPoint(int owner, SurfaceLocation location, Vec3 point) {
        Transform place = moved.get(owner);
        Vec3 there = place == null ? point : place.transformPoint(location.local());
        return difference(point.minus(scene.camera().from()), there.minus(other.camera().from()));
    }

    /** Returns the same of a point of the background, which is infinitely far. */
    double[] ofDirection(Vec3 direction) {
        return difference(direction, direction);
    }

    private double[] difference(Vec3 direction, Vec3 otherDirection) {
        double[] here = rays.imagePosition(direction);
        double[] there = otherRays.imagePosition(otherDirection);
        if (here == null || there == null) {
            return new double[2];
        }
        double[] result = {there[0] - here[0], there[1] - here[1]};
        return Float.isFinite((float) result[0]) && Float.isFinite((float) result[1]) ? result : new double[2];
    }

    /** Returns the vectors to the previous and to the next frame. */
    static List<MotionVectors> of(Scene scene, ShotFrame frame) {
        return List.of(new MotionVectors(scene, frame.previous()), new MotionVectors(scene, frame.next()));
    }
}
