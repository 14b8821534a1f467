package lightning.render.trace;

import lightning.base.math.Ray;
import lightning.scene.Scene;

/** The eye of a scene: which rays belong to which pixel. */
public final class PixelRays {
    private final CameraRays rays;

    public PixelRays(Scene scene) {
        rays = new CameraRays(scene.camera(), scene.picture());
    }

    /** The ray, of length 1, through the center of a pixel: {@code x} from the left, {@code y} from the top. */
    public Ray ray(int x, int y) {
        return rays.pixelRay(x, y);
    }

    /**
     * The ray, of length 1, through sample {@code sample} of a pixel that has {@code grid} × {@code grid} of them, each in
     * the middle of its cell, counted along the lines from the upper left.
     */
    public Ray ray(int x, int y, int sample, int grid) {
        return rays.imageRay(x + SamplePositions.offset(sample % grid, grid), y + SamplePositions.offset(sample / grid, grid));
    }
}
