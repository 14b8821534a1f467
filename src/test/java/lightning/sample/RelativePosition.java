package lightning.sample;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;

/** Where a light stands, told so that it means something in any scene. */
sealed interface RelativePosition {

    /** The place in a scene's coordinates. */
    Vec3 in(Scene scene);

    /** About the point that the camera looks at, in sevenths of the camera's distance from it. */
    record Near(Vec3 at) implements RelativePosition {
        @Override
        public Vec3 in(Scene scene) {
            Camera camera = scene.camera();
            return camera.to().plus(at.times(camera.from().minus(camera.to()).length() / 7));
        }
    }

    /** At the origin of a shape's own space: inside it, or on its base. */
    record InShape(int index) implements RelativePosition {
        @Override
        public Vec3 in(Scene scene) {
            List<PlacedShape> shapes = scene.placedShapes();
            return shapes.isEmpty() ? Vec3.ZERO : shapes.get(index % shapes.size()).toWorld().transformPoint(Vec3.ZERO);
        }
    }

    /** At the stored point of the row that a pixel shows, so that its distance to the light is 0. */
    record OnRow(int x, int y) implements RelativePosition {
        @Override
        public Vec3 in(Scene scene) {
            Geometry geometry = new Geometry(scene);
            Ray ray = new PixelRays(scene).ray(x % scene.picture().width(), y % scene.picture().height());
            int shape = geometry.nearestBruteForce(ray);
            if (shape < 0) {
                return scene.camera().to();
            }
            SurfacePoint point = geometry.surface(shape, ray);
            return geometry.toScene(new Vec3(point.px(), point.py(), point.pz()));
        }
    }
}
