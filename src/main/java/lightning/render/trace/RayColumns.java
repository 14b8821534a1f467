package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.RayBeam;
import org.jspecify.annotations.Nullable;

/** Rays of one tile, up to 1024, and their hits, as columns that share one index. Reused; not thread-safe. */
public final class RayColumns {
    /** Maximum number of rays: one for each pixel of a tile. */
    static final int MAX_RAYS = 1024;
    /** Lanes may overrun the end of a column by less than this. */
    private static final int OVERRUN = 64;

    /** Number of rays. */
    public int count;
    /** Rays per line if the rays are those of all pixels of a rectangle, line by line; otherwise 0. */
    public int columns;
    /** Origin of camera rays, render space. */
    private final Vec3 eye;
    /** Rows that the rays start from; null for camera rays. */
    @Nullable
    HitRows sourceRows;
    /** Origins of the rays by row; null for camera rays. */
    public float @Nullable [] startX;
    public float @Nullable [] startY;
    public float @Nullable [] startZ;
    /** Source of each ray: a row of {@link #sourceRows}, or a pixel or sample of the tile. */
    public final short[] slot = new short[MAX_RAYS];
    /** Directions, of any length. */
    public final double[] dx = new double[MAX_RAYS + OVERRUN];
    public final double[] dy = new double[MAX_RAYS + OVERRUN];
    public final double[] dz = new double[MAX_RAYS + OVERRUN];
    /** Distance of the nearest hit, {@code +∞} for a miss. */
    public final double[] t = new double[MAX_RAYS];
    /** Primitive of the nearest hit, −1 for a miss. */
    public final int[] primitive = new int[MAX_RAYS];
    /** Part of the primitive that was hit. */
    public final int[] part = new int[MAX_RAYS];

    /** Whether points on meshes with vertex normals stay on their facets; otherwise they are lifted, as those of a picture. */
    public boolean startsAtFacets;
    /** Number of rays that hit a primitive. */
    public int hitCount;
    /** Rays that hit a primitive, in the order of their rows. */
    public final short[] order = new short[MAX_RAYS];
    /** Hits in local coordinates of their shapes, in the same order; for textures. */
    public final double[] localX = new double[MAX_RAYS];
    public final double[] localY = new double[MAX_RAYS];
    public final double[] localZ = new double[MAX_RAYS];

    private final double[] range = new double[2];

    RayColumns(CameraRays camera) {
        eye = camera.eye;
    }

    /** Sets the camera as the origin of the rays. */
    void startAtEye() {
        sourceRows = null;
        startX = null;
        startY = null;
        startZ = null;
    }

    /** Sets rows as the origins of the rays. */
    void startAtRows(HitRows rows, BounceKind bounce) {
        sourceRows = rows;
        startX = bounce.originX(rows);
        startY = bounce.originY(rows);
        startZ = bounce.originZ(rows);
    }

    /** Adds the directions of all rays, at least one, to a beam. */
    void addDirectionsTo(RayBeam beam, Tracer tracer) {
        addDirectionsTo(beam, 0, dx, tracer);
        addDirectionsTo(beam, 1, dy, tracer);
        addDirectionsTo(beam, 2, dz, tracer);
    }

    private void addDirectionsTo(RayBeam beam, int axis, double[] components, Tracer tracer) {
        tracer.range(components, count, range);
        beam.addDirectionRange(axis, range[0], range[1]);
    }

    /** Returns the x coordinate of a ray's origin. */
    public double originX(int ray) {
        return startX == null ? eye.x() : startX[slot[ray]];
    }

    public double originY(int ray) {
        return startY == null ? eye.y() : startY[slot[ray]];
    }

    public double originZ(int ray) {
        return startZ == null ? eye.z() : startZ[slot[ray]];
    }
}
