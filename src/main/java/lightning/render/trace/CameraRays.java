package lightning.render.trace;

import lightning.base.math.Ray;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;

/**
 * Camera rays through points of the image. They start at the eye, which is the origin of render space unless the camera sets
 * another one.
 *
 * <p>The direction through image coordinates x, y (pixels from the left and from the top) is {@code corner + x·right + y·down},
 * normalized.
 */
public final class CameraRays {
    /** Origin of the rays, render space. */
    final Vec3 eye;
    public final Vec3 corner;
    public final Vec3 right;
    public final Vec3 down;

    public CameraRays(Camera camera, PictureSettings picture) {
        eye = camera.from().minus(camera.origin());
        Vec3 forward = camera.to().minus(camera.from()).normalized();
        Vec3 side = forward.cross(camera.up().normalized()).normalized();
        Vec3 up = side.cross(forward);
        double half = camera.fov() / 2;
        double tangent = Transform.sinDegrees(half) / Transform.cosDegrees(half);
        double pixel = 2 * tangent / picture.height();
        right = side.times(pixel);
        down = up.times(-pixel);
        double column = picture.width() * (0.5 - camera.shift().x());
        double row = picture.height() * (0.5 + camera.shift().y());
        corner = forward.minus(right.times(column)).minus(down.times(row));
    }

    /** Returns the ray through the center of pixel {@code column, row}; its direction has length 1. */
    public Ray pixelRay(int column, int row) {
        return imageRay(column + 0.5, row + 0.5);
    }

    /** Returns the ray through image coordinates x, y; its direction has length 1. */
    public Ray imageRay(double x, double y) {
        double[] dx = new double[1];
        double[] dy = new double[1];
        double[] dz = new double[1];
        writeDirection(x, y, dx, dy, dz, 0);
        return new Ray(eye, new Vec3(dx[0], dy[0], dz[0]));
    }

    /**
     * Sets a beam to bound exactly the rays through a rectangle of pixels.
     *
     * @param column leftmost pixel; {@code columns} is the number of pixels across
     * @param row topmost pixel; {@code rows} is the number of pixels down
     */
    public void boundBeam(RayBeam beam, int column, int row, int columns, int rows) {
        beam.clear();
        beam.addOrigin(eye.x(), eye.y(), eye.z());
        // Directions to the corners in the image plane. Pixel centers are half a pixel inside them.
        for (int end = 0; end < 4; end++) {
            double x = column + (end & 1) * columns;
            double y = row + (end >> 1) * rows;
            beam.addDirection(corner.x() + x * right.x() + y * down.x(),
                    corner.y() + x * right.y() + y * down.y(),
                    corner.z() + x * right.z() + y * down.z());
        }
    }

    /** Writes the direction, of length 1, of the ray through image coordinates x, y to index {@code i}. */
    public void writeDirection(double x, double y, double[] toX, double[] toY, double[] toZ, int i) {
        double dx = corner.x() + x * right.x() + y * down.x();
        double dy = corner.y() + x * right.y() + y * down.y();
        double dz = corner.z() + x * right.z() + y * down.z();
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        toX[i] = dx / length;
        toY[i] = dy / length;
        toZ[i] = dz / length;
    }
}
