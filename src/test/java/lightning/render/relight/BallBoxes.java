package lightning.render.relight;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.PixelRays;
import lightning.scene.Scene;

/** Bounding boxes of spheres of radius 1, given by their centers, and the rays that meet them. */
final class BallBoxes {
    private BallBoxes() {}

    /** Returns the number of camera rays that meet the box of any of the spheres. */
    static long eyeRays(Scene scene, Vec3... balls) {
        PixelRays eye = new PixelRays(scene);
        int width = scene.picture().width();
        return IntStream.range(0, width * scene.picture().height())
                .filter(i -> meets(scene, eye.ray(i % width, i / width), balls)).count();
    }

    /** Returns whether a ray, relative to the camera, meets any of the boxes. */
    static boolean meets(Scene scene, Ray ray, Vec3... balls) {
        return Arrays.stream(balls).anyMatch(ball -> meets(ray, ball.minus(scene.camera().origin())));
    }

    private static boolean meets(Ray ray, Vec3 ball) {
        Vec3 toTarget = ball.minus(ray.origin());
        double[] middle = {toTarget.x(), toTarget.y(), toTarget.z()};
        double[] direction = {ray.direction().x(), ray.direction().y(), ray.direction().z()};
        double in = 0;
        double out = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double near = (middle[axis] - 1) / direction[axis];
            double far = (middle[axis] + 1) / direction[axis];
            in = Math.max(in, Math.min(near, far));
            out = Math.min(out, Math.max(near, far));
        }
        return in <= out;
    }
}
