package lightning.render.fog;

import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;

/**
 * Grid of camera rays along which fog is sampled: one through every fourth corner of the pixels, and one more around the picture.
 *
 * <p>Rays of a block of 2×2 are sampled at four different places in turn, like the interleaved pixels of Keller and Heidrich (Interleaved
 * sampling, 2001). A filter over neighbors adds them up.
 */
public final class FogGrid {
    /** Pixels between neighboring rays, along x and y. */
    public static final int STEP = 4;
    /** Samples along a ray for each light. */
    public static final int SAMPLES = 32;
    /** Different places of samples. */
    public static final int PHASES = 4;
    private static final int[] ORDER = {0, 2, 3, 1};

    private final CameraRays camera;
    private final Vec3 eye;
    private final double scale;
    private final int columns;
    private final int lines;

    public FogGrid(Camera camera, PictureSettings picture) {
        this.camera = new CameraRays(camera, picture);
        eye = camera.from().minus(camera.origin());
        scale = camera.to().minus(camera.from()).length();
        columns = (picture.width() + STEP - 1) / STEP + 3;
        lines = (picture.height() + STEP - 1) / STEP + 3;
    }

    /** Returns the number of rays in a line. */
    public int columns() {
        return columns;
    }

    public int lines() {
        return lines;
    }

    /** Returns the number of rays. */
    public int count() {
        return columns * lines;
    }

    /** Returns the origin of all rays, render space. */
    public Vec3 eye() {
        return eye;
    }

    /** Returns the distance from the eye to the point that the camera looks at, scene units, &gt; 0. */
    public double scale() {
        return scale;
    }

    /** Returns the phase of a ray, 0…3. */
    public int phase(int ray) {
        return ORDER[(ray % columns & 1) | (ray / columns & 1) << 1];
    }

    /** Returns the place of a sample along a ray, 0…1, exclusive. */
    public double place(int sample, int phase) {
        return (sample + (phase + 0.5) / PHASES) / SAMPLES;
    }

    /** Returns where image coordinate x or y is in the grid, in rays. */
    public static double position(double pixels) {
        return pixels / STEP + 1;
    }

    /** Writes the unit direction of a ray to index {@code i}. */
    public void writeDirection(int ray, double[] dx, double[] dy, double[] dz, int i) {
        camera.writeDirection(STEP * (ray % columns - 1), STEP * (ray / columns - 1), dx, dy, dz, i);
    }

    /** Writes the unit direction of the ray through image coordinates x, y to index {@code i}. */
    public void writeDirection(double x, double y, double[] dx, double[] dy, double[] dz, int i) {
        camera.writeDirection(x, y, dx, dy, dz, i);
    }
}
