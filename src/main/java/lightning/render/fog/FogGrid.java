package lightning.render.fog;

import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;

/**
 * Grid of camera rays along which fog is sampled: one through the corner of every pixel of a small picture, of every fourth pixel of one of
 * 960 × 540 pixels or more, and one more around the picture.
 *
 * <p>Rays of a block of 2×2 are sampled at four different places in turn, like the interleaved pixels of Keller and Heidrich (Interleaved
 * sampling, 2001). A filter over neighbors adds them up.
 *
 * @param eye     origin of its rays, render space
 * @param scale   distance from the eye to the point that the camera looks at, scene units, &gt; 0
 * @param step    number of pixels between neighboring rays, along x and y: 1…4
 * @param columns number of rays in a line
 */
public record FogGrid(CameraRays camera, Vec3 eye, double scale, int step, int columns, int lines) implements FogRays {
    /** Largest number of pixels between neighboring rays, along x and y: that of pictures from 960 × 540 on. */
    private static final int MAX_STEP = 4;
    /** Number of rays of a picture of this size; a smaller one has as many at most. */
    private static final double RAYS = 960 / MAX_STEP * (540 / MAX_STEP);
    /** Samples along a ray for each light. */
    public static final int SAMPLES = 32;
    /** Different places of samples. */
    public static final int PHASES = 4;
    /** Rays along a side of a group. */
    private static final int SIDE = 32;
    private static final int[] ORDER = {0, 2, 3, 1};

    public FogGrid(Camera camera, PictureSettings picture) {
        this(camera, picture, Math.clamp((int) Math.ceil(Math.sqrt((double) picture.width() * picture.height() / RAYS)), 1, MAX_STEP));
    }

    private FogGrid(Camera camera, PictureSettings picture, int step) {
        this(new CameraRays(camera, picture), camera.from().minus(camera.origin()), camera.to().minus(camera.from()).length(), step,
                (picture.width() + step - 1) / step + 3, (picture.height() + step - 1) / step + 3);
    }

    @Override
    public FogGrid grid() {
        return this;
    }

    @Override
    public int count() {
        return columns * lines;
    }

    @Override
    public int groupCount() {
        return groupsAcross() * ((lines + SIDE - 1) / SIDE);
    }

    private int groupsAcross() {
        return (columns + SIDE - 1) / SIDE;
    }

    @Override
    public int writeGroup(int group, int[] to) {
        int left = group % groupsAcross() * SIDE;
        int top = group / groupsAcross() * SIDE;
        int count = 0;
        for (int y = top; y < Math.min(lines, top + SIDE); y++) {
            for (int x = left; x < Math.min(columns, left + SIDE); x++) {
                to[count++] = y * columns + x;
            }
        }
        return count;
    }

    /** Returns the phase of a ray, 0…3. */
    public int phase(int ray) {
        return ORDER[(ray % columns & 1) | (ray / columns & 1) << 1];
    }

    /** Returns the place of a sample along a ray, 0…1, exclusive. */
    public static double place(int sample, int phase) {
        return (sample + (phase + 0.5) / PHASES) / SAMPLES;
    }

    /** Returns where image coordinate x or y is in the grid, in rays. */
    public double position(double pixels) {
        return pixels / step + 1;
    }

    @Override
    public void set(int ray, FogRay to) {
        to.ox = eye.x();
        to.oy = eye.y();
        to.oz = eye.z();
        Vec3 direction = camera.imageRay(step * (ray % columns - 1), step * (ray / columns - 1)).direction();
        to.dx = direction.x();
        to.dy = direction.y();
        to.dz = direction.z();
        to.phase = phase(ray);
    }

    /** Writes the unit direction of the ray through image coordinates x, y to index {@code i}. */
    public void writeDirection(double x, double y, double[] dx, double[] dy, double[] dz, int i) {
        camera.writeDirection(x, y, dx, dy, dz, i);
    }
}
