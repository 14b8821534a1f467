package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.RayBeam;

/** The rays of one tile, up to 1024, in columns that share one index, and what they met. Reused; not shared between threads. */
public final class RayColumns {
    /** As many rays as a tile has pixels. */
    static final int MAX_RAYS = 1024;
    /** Lanes may run over the end of a column by less than this. */
    private static final int OVERRUN = 64;

    /** How many rays there are. */
    public int count;
    /** How many rays a line has, where they are those of all pixels of a rectangle, line by line; else 0. */
    public int columns;
    /** Where rays of the eye leave from, render space. */
    private final Vec3 eye;
    /** The rows that the rays leave from; null for rays of the eye. */
    HitRows sourceRows;
    /** Where rays leave from each row; null for rays of the eye. */
    public float[] startX;
    public float[] startY;
    public float[] startZ;
    /** Where a ray comes from: a row of {@link #sourceRows}, or a pixel or sample of the tile. */
    public final short[] slot = new short[MAX_RAYS];
    /** Directions, of any length. */
    public final double[] dx = new double[MAX_RAYS + OVERRUN];
    public final double[] dy = new double[MAX_RAYS + OVERRUN];
    public final double[] dz = new double[MAX_RAYS + OVERRUN];
    /** The distance of the nearest hit, {@code +∞} for a miss. */
    public final double[] t = new double[MAX_RAYS];
    /** The primitive of the nearest hit, −1 for a miss. */
    public final int[] primitive = new int[MAX_RAYS];
    /** The part of it that was hit. */
    public final int[] part = new int[MAX_RAYS];

    /** How many rays hit something. */
    public int hitCount;
    /** Those rays, in the order of their rows. */
    public final short[] order = new short[MAX_RAYS];
    /** Where these hits lie in the own space of their shapes, in the same order; for textures. */
    public final double[] localX = new double[MAX_RAYS];
    public final double[] localY = new double[MAX_RAYS];
    public final double[] localZ = new double[MAX_RAYS];

    private final double[] range = new double[2];

    RayColumns(CameraRays camera) {
        eye = camera.eye;
    }

    /** Lets the rays leave from the eye. */
    void startAtEye() {
        sourceRows = null;
        startX = null;
        startY = null;
        startZ = null;
    }

    /** Lets the rays leave from rows. */
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

    /** The origin of a ray. */
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
