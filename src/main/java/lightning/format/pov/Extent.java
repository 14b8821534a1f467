package lightning.format.pov;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Solid;

/**
 * A sphere around all shapes of a scene.
 *
 * @param radius scene units, &gt; 0
 */
record Extent(Vec3 center, double radius) {

    static Extent of(Scene scene) {
        List<PlacedShape> shapes = scene.placedShapes();
        if (shapes.isEmpty()) {
            return new Extent(scene.camera().to(), 1);
        }
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (PlacedShape shape : shapes) {
            switch (shape.shape().solid()) {
                case Solid.Canonical solid -> {
                    double[] box = solid.box();
                    for (int corner = 0; corner < 8; corner++) {
                        include(shape.toWorld()
                                .point(new Vec3(box[(corner & 1) * 3], box[(corner & 2) / 2 * 3 + 1], box[(corner & 4) / 4 * 3 + 2])),
                                low, high);
                    }
                }
                case Solid.Triangles t -> {
                    float[] v = t.mesh().positions();
                    for (int i = 0; i < v.length; i += 3) {
                        include(shape.toWorld().point(new Vec3(v[i], v[i + 1], v[i + 2])), low, high);
                    }
                }
            }
        }
        if (!(low[0] <= high[0])) {
            return new Extent(scene.camera().to(), 1);
        }
        Vec3 from = new Vec3(low[0], low[1], low[2]);
        Vec3 to = new Vec3(high[0], high[1], high[2]);
        return new Extent(from.plus(to).times(0.5), to.minus(from).length() / 2);
    }

    private static void include(Vec3 p, double[] low, double[] high) {
        double[] at = {p.x(), p.y(), p.z()};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(low[axis], at[axis]);
            high[axis] = Math.max(high[axis], at[axis]);
        }
    }
}
