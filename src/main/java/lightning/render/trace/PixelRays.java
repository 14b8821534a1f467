package lightning.render.trace;

import lightning.base.math.Ray;
import lightning.scene.Scene;

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
     * samples, each at the center of its cell, numbered row by row from the upper left.
     */
    public Ray ray(int x, int y, int sample, int grid) {
        return rays.imageRay(x + SamplePositions.offset(sample % grid, grid), y + SamplePositions.offset(sample / grid, grid));
    }
}
