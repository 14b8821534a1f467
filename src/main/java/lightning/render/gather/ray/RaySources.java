package lightning.render.gather.ray;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.RayBatch;
import org.jspecify.annotations.Nullable;

/** Points that cast rays: gather points or surfels. */
public final class RaySources {
    private final CellKeys keys;
    private final boolean areSurfels;
    public final SurfaceColumns surface;
    /** First gather point in cells of each size, {@link Integer#MAX_VALUE} for later ones. */
    public final int[] levelStart = new int[CellKeys.LEVELS];
    /** Unit normals of the surfaces, NaN where a point is shaded by this normal; those of {@link #tilted} if that is not null. */
    float[] geometricX = {};
    float[] geometricY = {};
    float[] geometricZ = {};
    /** Places at which rays of these points start: on their surfaces, where points may be lifted above them, even into other objects. */
    private float[][] start = new float[3][0];
    /** Null while the points cast rays for the first time. */
    private @Nullable TiltedFacets tilted;

    public RaySources(CellKeys keys, SurfaceColumns surface, boolean areSurfels) {
        this.keys = keys;
        this.surface = surface;
        this.areSurfels = areSurfels;
        Arrays.fill(levelStart, Integer.MAX_VALUE);
    }

    public CellKeys keys() {
        return keys;
    }

    /** Writes gather points without their keys. */
    public void writeTo(ColumnWriter out) throws IOException {
        surface.writeTo(out);
        out.writeArray(levelStart);
        requireNonNull(tilted).writeTo(out);
    }

    public static RaySources readFrom(ColumnReader in, CellKeys keys) throws IOException {
        var sources = new RaySources(keys, SurfaceColumns.readFrom(in), false);
        System.arraycopy(in.readInts(), 0, sources.levelStart, 0, CellKeys.LEVELS);
        sources.setNormals(TiltedFacets.readFrom(in));
        return sources;
    }

    /** Keeps only the normals of points that are shaded by another normal, and returns them. */
    public TiltedFacets packNormals() {
        TiltedFacets normals = TiltedFacets.of(new float[][] {geometricX, geometricY, geometricZ}, start);
        setNormals(normals);
        return normals;
    }

    public void setNormals(TiltedFacets normals) {
        tilted = normals;
        geometricX = normals.normal()[0];
        geometricY = normals.normal()[1];
        geometricZ = normals.normal()[2];
        start = normals.start();
    }

    public long normalBytes() {
        return requireNonNull(tilted).bytes();
    }

    /** Returns the index of a point's geometric normal; negative if it is shaded by that normal. */
    private int normal(int p) {
        return tilted != null ? tilted.index(p) : Float.isNaN(geometricX[p]) ? -1 : p;
    }

    /** Makes room for the normals of points {@code 0 … count − 1}. */
    public void reserveNormals(int count) {
        geometricX = Arrays.copyOf(geometricX, count);
        geometricY = Arrays.copyOf(geometricY, count);
        geometricZ = Arrays.copyOf(geometricZ, count);
        start = new float[][] {Arrays.copyOf(start[0], count), Arrays.copyOf(start[1], count), Arrays.copyOf(start[2], count)};
    }

    /** Sets that a point is shaded by the normal of its surface. */
    void setUntilted(int p) {
        geometricX[p] = Float.NaN;
        geometricY[p] = Float.NaN;
        geometricZ[p] = Float.NaN;
    }

    /**
     * Sets the surface under a point that is shaded by another normal.
     *
     * @param normal of the surface, of length 1
     * @param x      place at which rays start, render space, with {@code y} and {@code z}
     */
    void setFacet(int p, Vec3 normal, float x, float y, float z) {
        geometricX[p] = (float) normal.x();
        geometricY[p] = (float) normal.y();
        geometricZ[p] = (float) normal.z();
        start[0][p] = x;
        start[1][p] = y;
        start[2][p] = z;
    }

    /** Returns coordinate {@code axis} of the place at which rays of a point start, render space. */
    public float start(int p, int axis) {
        int normal = normal(p);
        return normal >= 0 ? start[axis][normal] : axis == 0 ? surface.px[p] : axis == 1 ? surface.py[p] : surface.pz[p];
    }

    /** Sets the start of a ray to that of a point's rays. */
    public void setStart(int p, RayBatch batch, int ray) {
        batch.startX[ray] = start(p, 0);
        batch.startY[ray] = start(p, 1);
        batch.startZ[ray] = start(p, 2);
    }

    /** Returns the seed of a point's directions. */
    public long seed(int p) {
        float x = surface.px[p];
        float y = surface.py[p];
        float z = surface.pz[p];
        return areSurfels ? keys.surfelSeed(x, y, z, surface.nx[p], surface.ny[p], surface.nz[p])
                : keys.pointSeed(x, y, z, surface.nx[p], surface.ny[p], surface.nz[p], level(p));
    }

    /**
     * Returns the rank of ray {@code k} of a point, as {@link CellKeys#rank}.
     *
     * @param seed of the point
     */
    public int rank(int p, long seed, int k) {
        return CellKeys.rank(seed, surface.px[p], surface.py[p], surface.pz[p], k);
    }

    private int level(int p) {
        int level = 0;
        while (level + 1 < levelStart.length && p >= levelStart[level + 1]) {
            level++;
        }
        return level;
    }

    /** Writes the usual directions of a point's rays, as below. */
    public void writeDirections(int p, DirectionTable directions, double[] toX, double[] toY, double[] toZ, int at) {
        writeDirections(p, directions, 0, toX, toY, toZ, at);
    }

    /**
     * Writes the directions of a point's rays to elements {@code at …}: cosine-distributed around the normal by which the point is
     * shaded. Bump maps and vertex normals tilt that normal, so some directions would go below the surface. They are reflected at its
     * plane: the light from above stands for the light that the tilted surface would meet.
     *
     * @param turn as in {@link DirectionTable#write}
     */
    public void writeDirections(int p, DirectionTable directions, int turn, double[] toX, double[] toY, double[] toZ, int at) {
        directions.write(seed(p), turn, surface.nx[p], surface.ny[p], surface.nz[p], toX, toY, toZ, at);
        int normal = normal(p);
        if (normal < 0) {
            return;
        }
        float nx = geometricX[normal];
        float ny = geometricY[normal];
        float nz = geometricZ[normal];
        for (int ray = at; ray < at + directions.rays(); ray++) {
            double height = toX[ray] * nx + toY[ray] * ny + toZ[ray] * nz;
            if (height < 0) {
                toX[ray] -= 2 * height * nx;
                toY[ray] -= 2 * height * ny;
                toZ[ray] -= 2 * height * nz;
            }
        }
    }

    /** Returns whether a direction goes above the plane of a point's surface: x, y, z. */
    public boolean isAbove(int p, double[] direction) {
        int normal = normal(p);
        return normal < 0 || direction[0] * geometricX[normal] + direction[1] * geometricY[normal] + direction[2] * geometricZ[normal] > 0;
    }

    /** Reflects a direction at the plane of a point's surface if it goes above it: x, y, z. */
    public void turnBelow(int p, double[] direction) {
        for (int i = 0; i < 3; i++) {
            direction[i] = -direction[i];
        }
        turnAbove(p, direction);
        for (int i = 0; i < 3; i++) {
            direction[i] = -direction[i];
        }
    }

    /** Reflects a direction at the plane of a point's surface if it goes below it: x, y, z; returns whether it did. */
    public boolean turnAbove(int p, double[] direction) {
        int normal = normal(p);
        if (normal < 0) {
            return false;
        }
        double height = direction[0] * geometricX[normal] + direction[1] * geometricY[normal] + direction[2] * geometricZ[normal];
        if (height < 0) {
            direction[0] -= 2 * height * geometricX[normal];
            direction[1] -= 2 * height * geometricY[normal];
            direction[2] -= 2 * height * geometricZ[normal];
        }
        return height < 0;
    }

    /**
     * Returns the density of a point's directions around one, in units of 1/π per steradian: the cosine to the normal, and that of the
     * direction that was reflected to it.
     *
     * @param x unit direction, with {@code y} and {@code z}
     */
    public double cosine(int p, double x, double y, double z) {
        double nx = surface.nx[p];
        double ny = surface.ny[p];
        double nz = surface.nz[p];
        double cosine = Math.max(0, x * nx + y * ny + z * nz);
        int normal = normal(p);
        if (normal < 0) {
            return cosine;
        }
        double gx = geometricX[normal];
        double gy = geometricY[normal];
        double gz = geometricZ[normal];
        double height = x * gx + y * gy + z * gz;
        double twice = 2 * height;
        return height <= 0 ? 0 : cosine + Math.max(0, (x - twice * gx) * nx + (y - twice * gy) * ny + (z - twice * gz) * nz);
    }

    /** Returns whether two points are at the same place with the same normals. */
    static boolean haveSameBits(RaySources a, int p, RaySources b, int q) {
        SurfaceColumns s = a.surface;
        SurfaceColumns t = b.surface;
        return haveSameBits(s.px[p], t.px[q]) && haveSameBits(s.py[p], t.py[q]) && haveSameBits(s.pz[p], t.pz[q])
                && haveSameBits(s.nx[p], t.nx[q]) && haveSameBits(s.ny[p], t.ny[q]) && haveSameBits(s.nz[p], t.nz[q])
                && haveSameNormals(a, a.normal(p), b, b.normal(q));
    }

    private static boolean haveSameNormals(RaySources a, int p, RaySources b, int q) {
        return p < 0 || q < 0 ? p < 0 && q < 0
                : haveSameBits(a.geometricX[p], b.geometricX[q]) && haveSameBits(a.geometricY[p], b.geometricY[q])
                        && haveSameBits(a.geometricZ[p], b.geometricZ[q]) && haveSameBits(a.start[0][p], b.start[0][q])
                        && haveSameBits(a.start[1][p], b.start[1][q]) && haveSameBits(a.start[2][p], b.start[2][q]);
    }

    private static boolean haveSameBits(float a, float b) {
        return Float.floatToIntBits(a) == Float.floatToIntBits(b);
    }
}
