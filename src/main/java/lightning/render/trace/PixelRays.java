package lightning.render.trace;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Camera rays of a scene by pixel and sample. */
public final class PixelRays {
    private final CameraRays rays;

    public PixelRays(Scene scene) {
        rays = new CameraRays(scene.camera(), scene.picture());
    }

    /** Returns the ray, of length 1, through the center of a pixel: {@code x} from the left, {@code y} from the top. */
    public Ray ray(int x, int y) {
        return rays.pixelRay(x, y);
    }

    /**
     * Returns the ray, of length 1, through sample {@code sample} of a pixel. The pixel has {@code grid} × {@code grid}
     * samples, each at the center of its cell, numbered row by row from the upper left. It starts at the sample's point on the lens.
     */
    public Ray ray(int x, int y, int sample, int grid) {
        return rays.sampleRay(x + SamplePositions.offset(sample % grid, grid), y + SamplePositions.offset(sample / grid, grid), sample,
                grid);
    }

    /**
     * Returns where the ray of a direction goes through the image: pixels from the left and from the top, {@code double[2]}; null if it
     * leads behind the camera. The inverse of {@link #ray(int, int)}: the center of the first pixel is at ½, ½.
     *
     * @param direction direction of any length; from the eye to a point, or to infinity
     */
    public double @Nullable [] imagePosition(Vec3 direction) {
        Vec3 normal = rays.right.cross(rays.down);
        double depth = direction.dot(normal) / rays.corner.dot(normal);
        if (!(depth > 0)) {
            return null;
        }
        Vec3 inPlane = direction.times(1 / depth).minus(rays.corner);
        return new double[] {inPlane.dot(rays.right) / rays.right.dot(rays.right), inPlane.dot(rays.down) / rays.down.dot(rays.down)};
    }
}
