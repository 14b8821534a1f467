package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.Beam;

/** The rays of one tile, up to 1024, in columns that share one index, and what they met. Reused; not shared between threads. */
public final class RayColumns {
    /** As many rays as a tile has pixels. */
    static final int MOST = 1024;
    /** Lanes may run over the end of a column by less than this. */
    private static final int OVERRUN = 64;

    /** How many rays there are. */
    public int count;
    /** How many rays a line has, where they are those of all pixels of a rectangle, line by line; else 0. */
    public int columns;
    /** Where rays of the eye leave from, render space. */
    private final Vec3 eye;
    /** The rows that the rays leave from; null for rays of the eye. */
    HitRows from;
    /** Where rays leave from each row; null for rays of the eye. */
    public float[] fromX;
    public float[] fromY;
    public float[] fromZ;
    /** Where a ray comes from: a row of {@link #from}, or a pixel or sample of the tile. */
    public final short[] slot = new short[MOST];
    /** Directions, of any length. */
    public final double[] dx = new double[MOST + OVERRUN];
    public final double[] dy = new double[MOST + OVERRUN];
    public final double[] dz = new double[MOST + OVERRUN];
    /** The distance of the nearest hit, {@code +∞} for a miss. */
    public final double[] t = new double[MOST];
    /** The primitive of the nearest hit, −1 for a miss. */
    public final int[] primitive = new int[MOST];
    /** The part of it that was hit. */
    public final int[] part = new int[MOST];

    /** How many rays hit something. */
    public int hits;
    /** Those rays, in the order of their rows. */
    public final short[] order = new short[MOST];
    /** Where these hits lie in the own space of their shapes, in the same order; for textures. */
    public final double[] ownX = new double[MOST];
    public final double[] ownY = new double[MOST];
    public final double[] ownZ = new double[MOST];

    private final double[] range = new double[2];

    RayColumns(CameraRays camera) {
        eye = camera.eye;
    }

    /** Lets the rays leave from the eye. */
    void fromEye() {
        from = null;
        fromX = null;
        fromY = null;
        fromZ = null;
    }

    /** Lets the rays leave from rows. */
    void from(HitRows rows, Bounce bounce) {
        from = rows;
        fromX = bounce.x(rows);
        fromY = bounce.y(rows);
        fromZ = bounce.z(rows);
    }

    /** Adds the directions of all rays, at least one, to a beam. */
    void sweep(Beam beam, Tracer tracer) {
        sweep(beam, 0, dx, tracer);
        sweep(beam, 1, dy, tracer);
        sweep(beam, 2, dz, tracer);
    }

    private void sweep(Beam beam, int axis, double[] components, Tracer tracer) {
        tracer.range(components, count, range);
        beam.directions(axis, range[0], range[1]);
    }

    /** The origin of a ray. */
    public double originX(int ray) {
        return fromX == null ? eye.x() : fromX[slot[ray]];
    }

    public double originY(int ray) {
        return fromY == null ? eye.y() : fromY[slot[ray]];
    }

    public double originZ(int ray) {
        return fromZ == null ? eye.z() : fromZ[slot[ray]];
    }
}
