package lightning.scene.paper;

import lightning.base.math.Vec3;
import lightning.scene.Camera;

/**
 * Directions and scale of the camera's view in scene units, to place visible edits. The bounds of the shapes are unsuitable, as a floor is
 * often many times wider than the objects on it.
 *
 * @param focus  target of the camera
 * @param extent half the image height at the focus
 * @param right  unit vector to the right of the image
 * @param up     unit vector to the top of the image
 * @param front  unit vector out of the image, towards the camera
 */
public record CameraFraming(Vec3 focus, double extent, Vec3 right, Vec3 up, Vec3 front) {

    public static CameraFraming of(Camera camera) {
        Vec3 back = camera.from().minus(camera.to());
        Vec3 front = back.normalized();
        Vec3 right = camera.up().normalized().cross(front).normalized();
        double extent = back.length() * StrictMath.tan(StrictMath.toRadians(camera.fov() / 2));
        return new CameraFraming(camera.to(), extent, right, front.cross(right), front);
    }

    /** Returns the vector with these components along right, up and front. */
    Vec3 vector(double rightPart, double upPart, double frontPart) {
        return right.times(rightPart).plus(up.times(upPart)).plus(front.times(frontPart));
    }

    /** Returns the point at these multiples of the extent right of, above and in front of the focus. */
    Vec3 point(double r, double u, double f) {
        return focus.plus(vector(r, u, f).times(extent));
    }
}
