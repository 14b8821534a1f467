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
    public static final int LEVELS = 4;
    /** Side of the largest cell of gather points in spacings: {@code LEVELS − 1} divisions leave a quarter of the spacing. */
    private static final double LARGEST = 2;
    /** Cells of surfels along the height of the picture. */
    private static final double SURFELS_PER_HEIGHT = 30;
    /** A surfel nearer to the ray's start than this many sides gets a smaller cell. */
    private static final double NEAR = 4;
    private static final long MASK = (1L << 21) - 1;
    /** Component of a unit normal between a direction along an axis and one between two axes: sin 22.5°. */
    private static final float OBLIQUE = 0.38f;
    private static final double MIN_DISTANCE = 1e-150;
    private static final long ANY_SURFACE = -1;

    private final double originX;
    private final double originY;
    private final double originZ;
    private final double eyeX;
    private final double eyeY;
    private final double eyeZ;
    /** Side of the largest gather cell, at distance 1. */
    private final double pointSide;
    private final double surfelSide;

    public CellKeys(Scene scene, IndirectSettings settings) {
        Camera camera = scene.camera();
        PictureSettings picture = scene.picture();
        originX = camera.origin().x();
        originY = camera.origin().y();
        originZ = camera.origin().z();
        Vec3 eye = camera.from().minus(camera.origin());
        eyeX = eye.x();
        eyeY = eye.y();
        eyeZ = eye.z();
        double height = 2 * StrictMath.tan(StrictMath.toRadians(camera.fov() / 2));
        pointSide = LARGEST * settings.spacing() * height / picture.height();
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

    /** Returns the side of the largest cells at a gather point, scene units. */
    double side(SurfaceColumns points, int p) {
        return side(points.px[p], points.py[p], points.pz[p], 0);
    }

    /** Returns the key of a gather point's cell. */
    public long pointKey(float x, float y, float z, float nx, float ny, float nz, int primitive, int level) {
        return pointKey(x, y, z, nx, ny, nz, (long) primitive, octave(x, y, z) - level);
    }

    private long pointKey(float x, float y, float z, float nx, float ny, float nz, long surface, int octave) {
        float ax = Math.abs(nx);
        float ay = Math.abs(ny);
        float az = Math.abs(nz);
        int normal = ax >= ay && ax >= az ? 10 * side(nx) + 3 * third(ny) + third(nz)
                : ay >= az ? 20 + 10 * side(ny) + 3 * third(nx) + third(nz) : 40 + 10 * side(nz) + 3 * third(nx) + third(ny);
        return key(x, y, z, Math.scalb(pointSide, octave), octave, 64 * surface + normal);
    }

    /**
     * Returns the seed of the directions of a gather point's rays. Points of one cell have the same, whatever the number of their surface
     * is: an edit of other objects leaves it as it is, and a moving camera mostly.
     *
     * @param level of the largest cell whose point it is
     */
    public long pointSeed(float x, float y, float z, float nx, float ny, float nz, int level) {
        return pointKey(x, y, z, nx, ny, nz, ANY_SURFACE, octave(x, y, z) - level);
    }

    /** Returns the seed of the directions of a surfel's rays. */
    public long surfelSeed(float x, float y, float z, float nx, float ny, float nz) {
        return pointKey(x, y, z, nx, ny, nz, ANY_SURFACE - 1, octave(x, y, z));
    }

    /**
     * Returns the key of a surfel's cell.
     *
     * @param distance length of the ray that hit it, scene units
     */
    public long surfelKey(float x, float y, float z, float nx, float ny, float nz, int primitive, double distance) {
        return surfelKey(x, y, z, nx, ny, nz, primitive, isNear(x, y, z, distance));
    }

    /** @param isNear whether the cell is small because the ray that hit the surfel is short */
    long surfelKey(float x, float y, float z, float nx, float ny, float nz, int primitive, boolean isNear) {
        int octave = surfelOctave(x, y, z, isNear);
        float ax = Math.abs(nx);
        float ay = Math.abs(ny);
        float az = Math.abs(nz);
        int normal = ax >= ay && ax >= az ? side(nx) : ay >= az ? 2 + side(ny) : 4 + side(nz);
        return key(x, y, z, Math.scalb(surfelSide, octave), octave, 8 * (long) primitive + normal);
    }

    private int surfelOctave(float x, float y, float z, boolean isNear) {
        return octave(x, y, z) - (isNear ? 1 : 0);
    }

    /**
     * Returns the side of a surfel's cell, scene units.
     *
     * @param distance length of the ray that hit it, scene units
     */
    public double surfelSide(float x, float y, float z, double distance) {
        return Math.scalb(surfelSide, surfelOctave(x, y, z, isNear(x, y, z, distance)));
    }

    private boolean isNear(float x, float y, float z, double distance) {
        return distance < NEAR * Math.scalb(surfelSide, octave(x, y, z));
    }

    private static int side(float component) {
        return component > 0 ? 1 : 0;
    }

    private static int third(float component) {
        return component < -OBLIQUE ? 0 : component > OBLIQUE ? 2 : 1;
    }

    /** Cells lie at the same places for every camera, so that a shot's frames mostly gather light at the same places. */
    private long key(float x, float y, float z, double side, int octave, long surface) {
        long i = (long) Math.floor((x + originX) / side) & MASK;
        long j = (long) Math.floor((y + originY) / side) & MASK;
        long k = (long) Math.floor((z + originZ) / side) & MASK;
        return Hash64.mix(Hash64.mix(i << 42 | j << 21 | k) + surface * 0x9e3779b97f4a7c15L + octave);
    }
}
