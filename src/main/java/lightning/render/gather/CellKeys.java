package lightning.render.gather;

import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Keys of the cells into which surfaces are divided. A cell contains points of one primitive with similar normals. Its side grows with
 * the distance from the eye in steps of 2, so that it covers about the same number of pixels everywhere. Cells with equal keys are one
 * cell; that happens once in 2⁶⁴ pairs.
 */
public final class CellKeys {
    /** Sizes of the cells of gather points; each is half of the previous. */
    public static final int LEVELS = 3;
    /** Cells of surfels along the height of the picture. */
    private static final double SURFELS_PER_HEIGHT = 30;
    /** A surfel nearer to the ray's start than this many sides gets a smaller cell. */
    private static final double NEAR = 4;
    private static final long MASK = (1L << 21) - 1;
    /** Component of a unit normal between a direction along an axis and one between two axes: sin 22.5°. */
    private static final float OBLIQUE = 0.38f;
    private static final double MIN_DISTANCE = 1e-150;

    private final double eyeX;
    private final double eyeY;
    private final double eyeZ;
    /** Side of the largest gather cell, at distance 1. */
    private final double pointSide;
    private final double surfelSide;

    public CellKeys(Scene scene, IndirectSettings settings) {
        Camera camera = scene.camera();
        PictureSettings picture = scene.picture();
        Vec3 eye = camera.from().minus(camera.origin());
        eyeX = eye.x();
        eyeY = eye.y();
        eyeZ = eye.z();
        double height = 2 * StrictMath.tan(StrictMath.toRadians(camera.fov() / 2));
        pointSide = settings.spacing() * height / picture.height();
        surfelSide = height / SURFELS_PER_HEIGHT;
    }

    /** Returns the exponent of the distance to the eye. */
    private int octave(float x, float y, float z) {
        double dx = x - eyeX;
        double dy = y - eyeY;
        double dz = z - eyeZ;
        return Math.getExponent(Math.max(Math.sqrt(dx * dx + dy * dy + dz * dz), MIN_DISTANCE));
    }

    /**
     * Returns the side of the cells of gather points, scene units.
     *
     * @param level 0 for the largest
     */
    public double side(float x, float y, float z, int level) {
        return Math.scalb(pointSide, octave(x, y, z) - level);
    }

    /** Returns the key of a gather point's cell. */
    public long pointKey(float x, float y, float z, float nx, float ny, float nz, int primitive, int level) {
        int octave = octave(x, y, z) - level;
        float ax = Math.abs(nx);
        float ay = Math.abs(ny);
        float az = Math.abs(nz);
        int normal = ax >= ay && ax >= az ? 10 * side(nx) + 3 * third(ny) + third(nz)
                : ay >= az ? 20 + 10 * side(ny) + 3 * third(nx) + third(nz) : 40 + 10 * side(nz) + 3 * third(nx) + third(ny);
        return key(x, y, z, Math.scalb(pointSide, octave), octave, 64 * (long) primitive + normal);
    }

    /**
     * Returns the key of a surfel's cell.
     *
     * @param distance length of the ray that hit it, scene units
     */
    public long surfelKey(float x, float y, float z, float nx, float ny, float nz, int primitive, double distance) {
        int octave = octave(x, y, z);
        if (distance < NEAR * Math.scalb(surfelSide, octave)) {
            octave--;
        }
        float ax = Math.abs(nx);
        float ay = Math.abs(ny);
        float az = Math.abs(nz);
        int normal = ax >= ay && ax >= az ? side(nx) : ay >= az ? 2 + side(ny) : 4 + side(nz);
        return key(x, y, z, Math.scalb(surfelSide, octave), octave, 8 * (long) primitive + normal);
    }

    private static int side(float component) {
        return component > 0 ? 1 : 0;
    }

    private static int third(float component) {
        return component < -OBLIQUE ? 0 : component > OBLIQUE ? 2 : 1;
    }

    private static long key(float x, float y, float z, double side, int octave, long surface) {
        long i = (long) Math.floor(x / side) & MASK;
        long j = (long) Math.floor(y / side) & MASK;
        long k = (long) Math.floor(z / side) & MASK;
        return Hash64.mix(Hash64.mix(i << 42 | j << 21 | k) + surface * 0x9e3779b97f4a7c15L + octave);
    }
}
