package lightning.format.pov;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.node.Solid;

/**
 * Bounding sphere of all shapes of a scene.
 *
 * @param radius scene units, &gt; 0
 */
record BoundingSphere(Vec3 center, double radius) {
    /** Radius of a scene that is one point. Distances to lights and their squares are divided by it. */
    private static final double MIN_RADIUS = 1e-6;

    static BoundingSphere of(Scene scene) {
        List<PlacedShape> shapes = scene.placedShapes();
        if (shapes.isEmpty()) {
            return new BoundingSphere(scene.camera().to(), 1);
        }
        double[] min = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] max = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (PlacedShape shape : shapes) {
            switch (shape.shape().solid()) {
                case Solid.Canonical solid -> {
                    double[] box = solid.bounds();
                    for (int corner = 0; corner < 8; corner++) {
                        include(shape.toWorld()
                                .transformPoint(
                                        new Vec3(box[(corner & 1) * 3], box[(corner & 2) / 2 * 3 + 1], box[(corner & 4) / 4 * 3 + 2])),
                                min, max);
                    }
                }
                case Solid.TriangleMesh t -> {
                    float[] v = t.mesh().positions();
                    for (int i = 0; i < v.length; i += 3) {
                        include(shape.toWorld().transformPoint(new Vec3(v[i], v[i + 1], v[i + 2])), min, max);
                    }
                }
            }
        }
        if (!(min[0] <= max[0])) {
            return new BoundingSphere(scene.camera().to(), 1);
        }
        Vec3 minCorner = new Vec3(min[0], min[1], min[2]);
        Vec3 maxCorner = new Vec3(max[0], max[1], max[2]);
        return new BoundingSphere(minCorner.plus(maxCorner).times(0.5),
                Math.max(maxCorner.minus(minCorner).length() / 2, MIN_RADIUS));
    }

    private static void include(Vec3 p, double[] min, double[] max) {
        double[] coordinates = {p.x(), p.y(), p.z()};
        for (int axis = 0; axis < 3; axis++) {
            min[axis] = Math.min(min[axis], coordinates[axis]);
            max[axis] = Math.max(max[axis], coordinates[axis]);
        }
    }
}
