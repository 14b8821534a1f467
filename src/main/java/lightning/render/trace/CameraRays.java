package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import lightning.base.math.Ray;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import org.jspecify.annotations.Nullable;

/**
 * Camera rays through points of the image. They start at the eye, which is the origin of render space unless the camera sets
 * another one; those of finer samples through an open lens start at points of the lens.
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
    private final Vec3 side;
    private final Vec3 up;
    private final double focusDistance;
    /** Null for a pinhole. */
    private final @Nullable LensSamples lens;

    public CameraRays(Camera camera, PictureSettings picture) {
        eye = camera.from().minus(camera.origin());
        Vec3 forward = camera.to().minus(camera.from()).normalized();
        side = forward.cross(camera.up().normalized()).normalized();
        up = side.cross(forward);
        double half = camera.fov() / 2;
        double tangent = Transform.sinDegrees(half) / Transform.cosDegrees(half);
        double pixel = 2 * tangent / picture.height();
        right = side.times(pixel);
        down = up.times(-pixel);
        double column = picture.width() * (0.5 - camera.shift().x());
        double row = picture.height() * (0.5 + camera.shift().y());
        corner = forward.minus(right.times(column)).minus(down.times(row));
        focusDistance = camera.focusDistance();
        lens = camera.lens().isOpen() ? new LensSamples(camera.lens()) : null;
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

    /** Returns whether finer samples start at other points than the eye. */
    boolean hasOpenLens() {
        return lens != null;
    }

    /** Returns the ray of a finer sample through image coordinates x, y; its direction has length 1. */
    Ray sampleRay(double x, double y, int cell, int grid) {
        if (lens == null) {
            return imageRay(x, y);
        }
        float[] from = new float[3];
        double[] to = new double[3];
        writeLensRay(x, y, cell, grid, from, to);
        return new Ray(new Vec3(from[0], from[1], from[2]), new Vec3(to[0], to[1], to[2]));
    }

    /**
     * Writes the ray of a finer sample through an open lens: from its point on the lens to the point of the plane of focus that the eye sees
     * at the sample's image coordinates x, y.
     *
     * @param cell cell of the sample in the pixel's grid
     * @param from {@code float[3]}, render space
     * @param to   direction of length 1, {@code double[3]}
     */
    void writeLensRay(double x, double y, int cell, int grid, float[] from, double[] to) {
        requireNonNull(lens).write((int) x, (int) y, cell, grid, to);
        double acrossX = to[0];
        double acrossY = to[1];
        from[0] = (float) (eye.x() + acrossX * side.x() + acrossY * up.x());
        from[1] = (float) (eye.y() + acrossX * side.y() + acrossY * up.y());
        from[2] = (float) (eye.z() + acrossX * side.z() + acrossY * up.z());
        double dx = eye.x() + focusDistance * (corner.x() + x * right.x() + y * down.x()) - from[0];
        double dy = eye.y() + focusDistance * (corner.y() + x * right.y() + y * down.y()) - from[1];
        double dz = eye.z() + focusDistance * (corner.z() + x * right.z() + y * down.z()) - from[2];
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        to[0] = dx / length;
        to[1] = dy / length;
        to[2] = dz / length;
    }
}
