package lightning.sample;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;

/** Position of a light relative to a scene's content. */
sealed interface RelativePosition {

    /** Returns the position in scene coordinates. */
    Vec3 in(Scene scene);

    /** Around the camera's target, in sevenths of the camera's distance. */
    record Near(Vec3 at) implements RelativePosition {
        @Override
        public Vec3 in(Scene scene) {
            Camera camera = scene.camera();
            return camera.to().plus(at.times(camera.from().minus(camera.to()).length() / 7));
        }
    }

    /** At the origin of a shape's local space: inside it, or on its base. */
    record InShape(int index) implements RelativePosition {
        @Override
        public Vec3 in(Scene scene) {
            List<PlacedShape> shapes = scene.placedShapes();
            return shapes.isEmpty() ? Vec3.ZERO : shapes.get(index % shapes.size()).toWorld().transformPoint(Vec3.ZERO);
        }
    }

    /** At the shading point of a pixel, so that its distance to the light is 0. */
    record OnRow(int x, int y) implements RelativePosition {
        @Override
        public Vec3 in(Scene scene) {
            Geometry geometry = Geometry.of(scene);
            Ray ray = new PixelRays(scene).ray(x % scene.picture().width(), y % scene.picture().height());
            int shape = BruteForce.nearest(geometry, ray);
            if (shape < 0) {
                return scene.camera().to();
            }
            SurfacePoint point = geometry.surface(shape, ray);
            return geometry.toScene(new Vec3(point.px(), point.py(), point.pz()));
        }
    }
}
