package lightning.render.gather.cell;

import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.render.trace.HitRows;
import lightning.scene.Camera;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Keys of the cells into which surfaces are divided. A cell contains points of one primitive with similar normals. Its side grows with
 * the distance from the eye in steps of 2, so that it covers about the same number of pixels everywhere. Cells of surfels far outside a narrow view are wider. Cells with equal keys are one
 * cell; that happens once in 2⁶⁰ pairs. The lowest four bits of a key are the place of the cell among its neighbors.
 */
public final class CellKeys {
    /** Sizes of the cells of gather points; each is half of the previous. */
    public static final int LEVELS = 3;
    /** Most cells of surfels along the height of the picture, and the pixels that a cell has at least: a small picture shows less. */
    private static final double SURFELS_PER_HEIGHT = 30;
    private static final double PIXELS_PER_SURFEL = 6;
    /**
     * Height of the picture at distance 1 to which surfels outside a narrower view are adapted: that of a view of 40°. Cells as small as those in the
     * view would divide the whole scene around it into so many surfels that a close-up never ends.
     */
    private static final double USUAL_HEIGHT = 2 * StrictMath.tan(StrictMath.toRadians(20));
    /** A surfel nearer to the ray's start than this many sides gets a smaller cell. */
    private static final double NEAR = 4;
    private static final long MASK = (1L << 21) - 1;
    /** Neighboring cells are at this many places along each axis of a square, in turns. */
    private static final int PLACES = 4;
    /** Component of a unit normal between a direction along an axis and one between two axes: sin 22.5°. */
    private static final float OBLIQUE = 0.38f;
    private static final double MIN_DISTANCE = 1e-150;
    private static final long ANY_SURFACE = -1;
    /** Logarithm of the width of a wide cell in sides of the largest cells of gather points. */
    private static final int WIDE = 4;
    /** Place of the kind of a part above the numbers of primitives and axes. */
    private static final int PART_SHIFT = 40;
    /** Most halvings of a surfel's cell. */
    private static final int MAX_DETAIL = 3;

    private final double originX;
    private final double originY;
    private final double originZ;
    private final double eyeX;
    private final double eyeY;
    private final double eyeZ;
    /** Side of the largest gather cell, at distance 1. */
    private final double pointSide;
    private final double surfelSide;
    /** Direction through the middle of the picture, of length 1. */
    private final Vec3 axis;
    /** Tangent of the largest angle between it and a corner of the picture. */
    private final double cornerTangent;
    /** Most doublings of the cells of surfels outside the view. */
    private final int maxWidening;
    private final int misses;

    public CellKeys(Scene scene, GatherSettings settings) {
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
        pointSide = settings.pixelSpacing(picture) * height / picture.height();
        surfelSide = height / Math.min(SURFELS_PER_HEIGHT, picture.height() / PIXELS_PER_SURFEL);
        CameraRays rays = new CameraRays(camera, picture);
        axis = rays.imageRay(picture.width() / 2.0, picture.height() / 2.0).direction();
        double tangent = 0;
        for (int end = 0; end < 4; end++) {
            Vec3 toCorner = rays.imageRay((end & 1) * picture.width(), (end >> 1) * picture.height()).direction();
            tangent = Math.max(tangent, tangentToAxis(toCorner.x(), toCorner.y(), toCorner.z()));
        }
        cornerTangent = tangent;
        maxWidening = Math.max(0, Math.getExponent(USUAL_HEIGHT / height));
        misses = settings.environment() ? DirectionCells.COUNT : 1;
    }

    /** Returns the number of cells of the directions of rays that hit nothing. */
    public int misses() {
        return misses;
    }

    /** Returns the exponent of the distance to the eye. */
    private int octave(float x, float y, float z) {
        double dx = x - eyeX;
        double dy = y - eyeY;
        double dz = z - eyeZ;
        return Math.getExponent(Math.max(Math.sqrt(dx * dx + dy * dy + dz * dz), MIN_DISTANCE));
    }

    /** Returns the tangent of the angle between a direction of any length and the axis of the view; +∞ from 90° on. */
    private double tangentToAxis(double x, double y, double z) {
        double depth = x * axis.x() + y * axis.y() + z * axis.z();
        double across = Math.sqrt(Math.max(0, x * x + y * y + z * z - depth * depth));
        return depth > 0 ? across / depth : Double.POSITIVE_INFINITY;
    }

    /** Returns how often the cell of a surfel is doubled because the view is narrow and far from it. */
    private int widening(float x, float y, float z) {
        return maxWidening == 0 ? 0
                : Math.clamp(Math.getExponent(2 * tangentToAxis(x - eyeX, y - eyeY, z - eyeZ) / cornerTangent), 0, maxWidening);
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
    public double side(SurfaceColumns points, int p) {
        return side(points.px[p], points.py[p], points.pz[p], 0);
    }

    /** Returns the key of a gather point's cell. */
    public long pointKey(float x, float y, float z, float nx, float ny, float nz, int primitive, int level) {
        return pointCell(x, y, z, nx, ny, nz, primitive, octave(x, y, z) - level);
    }

    private long pointCell(float x, float y, float z, float nx, float ny, float nz, long surface, int octave) {
        float ax = Math.abs(nx);
        float ay = Math.abs(ny);
        float az = Math.abs(nz);
        int normal = ax >= ay && ax >= az ? 10 * side(nx) + 3 * third(ny) + third(nz)
                : ay >= az ? 20 + 10 * side(ny) + 3 * third(nx) + third(nz) : 40 + 10 * side(nz) + 3 * third(nx) + third(ny);
        return key(x, y, z, Math.scalb(pointSide, octave), octave, 64 * surface + normal);
    }

    /** Returns the key of a wide cell, sixteen times as wide as the largest cell of gather points there. It may contain several surfaces. */
    public long wideKey(float x, float y, float z, float nx, float ny, float nz) {
        return pointCell(x, y, z, nx, ny, nz, ANY_SURFACE, octave(x, y, z) + WIDE);
    }

    /**
     * Returns the seed of the directions of a gather point's rays. Points of one cell have the same, whatever the number of their surface
     * is: an edit of other objects leaves it as it is, and a moving camera mostly.
     *
     * @param level of the largest cell whose point it is
     */
    public long pointSeed(float x, float y, float z, float nx, float ny, float nz, int level) {
        return pointCell(x, y, z, nx, ny, nz, ANY_SURFACE, octave(x, y, z) - level);
    }

    /** Returns the seed of the directions of a surfel's rays. */
    public long surfelSeed(float x, float y, float z, float nx, float ny, float nz) {
        int octave = surfelOctave(x, y, z, false);
        return key(x, y, z, Math.scalb(surfelSide, octave), octave, 8 * ANY_SURFACE + axis(nx, ny, nz));
    }

    /**
     * Returns the rank of a ray among those that hit a cell: the surfel is the hit of the lowest. Ranks are as good as random, and do not
     * depend on the number of the point that casts the ray.
     *
     * @param seed of the point's directions
     * @param x    place of the point, with {@code y} and {@code z}
     * @param k    number of the ray among the point's
     * @return 0 or more
     */
    public static int rank(long seed, float x, float y, float z, int k) {
        long place = (long) Float.floatToIntBits(x) << 32 ^ (long) Float.floatToIntBits(y) << 16 ^ Float.floatToIntBits(z);
        return (int) (Hash64.mix(seed + place + k * 0x9e3779b97f4a7c15L) >>> 33);
    }

    /**
     * Returns the key of a surfel's cell.
     *
     * @param distance length of the ray that hit it, scene units
     */
    public long surfelKey(float x, float y, float z, float nx, float ny, float nz, int primitive, double distance) {
        return surfelKey(x, y, z, nx, ny, nz, primitive, isNear(x, y, z, distance));
    }

    /** Returns the key of the cell of a row, as {@link #surfelKey(float, float, float, float, float, float, int, double)}. */
    public long surfelKey(HitRows rows, int row, int primitive, double distance) {
        return surfelKey(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], primitive, distance);
    }

    /** @param isNear whether the cell is small because the ray that hit the surfel is short */
    public long surfelKey(float x, float y, float z, float nx, float ny, float nz, int primitive, boolean isNear) {
        int octave = surfelOctave(x, y, z, isNear);
        return key(x, y, z, Math.scalb(surfelSide, octave), octave, 8 * (long) primitive + axis(nx, ny, nz));
    }

    /**
     * Returns the key of a cell of reflection points: of similar position and similar direction of the mirrored view.
     *
     * @param rx   mirrored view, as {@code ry} and {@code rz}
     * @param step width of the cells of directions, about radians
     */
    public long reflectionKey(float x, float y, float z, float rx, float ry, float rz, double step, int primitive, int level) {
        int octave = octave(x, y, z) - level;
        long i = (long) Math.floor(rx / step) & MASK;
        long j = (long) Math.floor(ry / step) & MASK;
        long k = (long) Math.floor(rz / step) & MASK;
        return key(x, y, z, Math.scalb(pointSide, octave), octave, Hash64.mix(i << 42 | j << 21 | k) ^ primitive);
    }

    /**
     * Returns how often the cell of a surfel is halved where a narrow lobe meets it.
     *
     * @param distance length of the ray that hit it, scene units
     * @param width    width that the lobe has there, scene units
     */
    public int detailLevel(float x, float y, float z, double distance, double width) {
        double side = surfelSide(x, y, z, distance);
        int level = 0;
        while (level < MAX_DETAIL && side > width) {
            side /= 2;
            level++;
        }
        return level;
    }

    /** Returns the key of the part of a surfel's cell, which was halved {@code detail} times. Parts of different cells have different keys. */
    public long detailKey(float x, float y, float z, float nx, float ny, float nz, int primitive, double distance, int detail) {
        boolean isNear = isNear(x, y, z, distance);
        int octave = surfelOctave(x, y, z, isNear) - detail;
        long cell = 2L * detail + (isNear ? 1 : 0);
        return key(x, y, z, Math.scalb(surfelSide, octave), octave, cell << PART_SHIFT | 8 * (long) primitive + axis(nx, ny, nz));
    }

    /** Returns the number of the axis that a normal is nearest to, and its side, 0…5. */
    private static int axis(float nx, float ny, float nz) {
        float ax = Math.abs(nx);
        float ay = Math.abs(ny);
        float az = Math.abs(nz);
        return ax >= ay && ax >= az ? side(nx) : ay >= az ? 2 + side(ny) : 4 + side(nz);
    }

    private int surfelOctave(float x, float y, float z, boolean isNear) {
        return octave(x, y, z) + widening(x, y, z) - (isNear ? 1 : 0);
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
        return distance < NEAR * Math.scalb(surfelSide, surfelOctave(x, y, z, false));
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
        long hash = Hash64.mix(Hash64.mix(i << 42 | j << 21 | k) + surface * 0x9e3779b97f4a7c15L + octave);
        return hash & -PLACES * PLACES | place(i, j, k);
    }

    /**
     * Returns the place of a cell among its neighbors, 0…15. All 4×4 neighbors in a plane along two axes have different places, because
     * the coefficients of any two axes have an odd determinant.
     */
    private static long place(long i, long j, long k) {
        return (i + 2 * j + k & PLACES - 1) * PLACES + (i + j + 2 * k & PLACES - 1);
    }
}
