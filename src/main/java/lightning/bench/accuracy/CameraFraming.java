package lightning.bench.accuracy;

import lightning.base.math.Vec3;
import lightning.scene.Camera;

/**
 * The directions and the scale of a picture, in scene units: where an edit must act to be seen. (The
 * bounds of the shapes would say less: a floor is often many times wider than what stands on it.)
 *
 * @param focus what the camera looks at
 * @param extent half the picture's height at the focus
 * @param right unit vector to the right of the picture
 * @param up    unit vector to its top
 * @param front unit vector out of the picture, towards the camera
 */
record CameraFraming(Vec3 focus, double extent, Vec3 right, Vec3 up, Vec3 front) {

    static CameraFraming of(Camera camera) {
        Vec3 back = camera.from().minus(camera.to());
        Vec3 front = back.normalized();
        Vec3 right = camera.up().normalized().cross(front).normalized();
        double extent = back.length() * StrictMath.tan(StrictMath.toRadians(camera.fov() / 2));
        return new CameraFraming(camera.to(), extent, right, front.cross(right), front);
    }

    /** The vector with these parts along right, up and front. */
    Vec3 vector(double rightPart, double upPart, double frontPart) {
        return right.times(rightPart).plus(up.times(upPart)).plus(front.times(frontPart));
    }

    /** The point that lies so many reaches right of, above and before the focus. */
    Vec3 point(double r, double u, double f) {
        return focus.plus(vector(r, u, f).times(extent));
    }
}
