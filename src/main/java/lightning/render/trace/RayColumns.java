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
    private final CameraRays camera;
    /** Origin of camera rays, render space. */
    private final Vec3 eye;
    /** Rows that the rays start from; null for camera rays. */
    @Nullable
    HitRows sourceRows;
    /** Origins of the rays by slot; null for camera rays that start at the eye. */
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
    /** Origins of rays through a lens, {@code float[3][MAX_RAYS]}; created on first use. */
    private float @Nullable [][] onLens;

    RayColumns(CameraRays camera) {
        this.camera = camera;
        eye = camera.eye;
    }

    /** Sets the camera as the origin of the rays. */
    void startAtEye() {
        sourceRows = null;
        startX = null;
        startY = null;
        startZ = null;
    }

    /** Sets origins and directions of the finer samples at some positions; their numbers are their slots. */
    void startAtSamples(SamplePositions positions, Tracer tracer) {
        startAtEye();
        if (positions.startOnLens(camera)) {
            float[][] from = onLens == null ? new float[3][MAX_RAYS] : onLens;
            onLens = from;
            positions.writeLensRays(camera, from[0], from[1], from[2], dx, dy, dz);
            startX = from[0];
            startY = from[1];
            startZ = from[2];
        } else {
            tracer.directSampleRays(camera, positions, this);
        }
    }

    /** Sets the origins of other camera rays, which have the same slots. */
    void startAsEyeRays(RayColumns o) {
        sourceRows = null;
        startX = o.startX;
        startY = o.startY;
        startZ = o.startZ;
    }

    /** Sets rows as the origins of the rays. */
    void startAtRows(HitRows rows, BounceKind bounce) {
        sourceRows = rows;
        startX = bounce.originX(rows);
        startY = bounce.originY(rows);
        startZ = bounce.originZ(rows);
    }

    /** Sets a beam to bound the camera rays of positions, at least one; those that start on the lens must be set before. */
    void boundCameraRays(RayBeam beam, SamplePositions positions, Tracer tracer) {
        if (positions.startOnLens(camera)) {
            bound(beam, tracer);
        } else {
            positions.boundBeam(beam, camera);
        }
    }

    /** Sets a beam to bound the rays, at least one. */
    void bound(RayBeam beam, Tracer tracer) {
        beam.clear();
        for (int i = 0; i < (startX == null ? 1 : count); i++) {
            beam.addOrigin(originX(i), originY(i), originZ(i));
        }
        addDirectionsTo(beam, tracer);
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
