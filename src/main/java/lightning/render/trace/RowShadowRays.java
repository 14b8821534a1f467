package lightning.render.trace;

import lightning.render.trace.tree.ShadowRayTarget;

/**
 * Where ways to a light lead that is another place, or another direction, for each row of a tile. Reused; not shared between
 * threads.
 */
public final class RowShadowRays {
    /** Lanes may run over the end of a column by less than this. */
    private static final int OVERRUN = 64;

    /** For each row the point, or the direction of any length but 0, up to the next multiple of 16 rows; render space. */
    public final double[] x = new double[RayColumns.MAX_RAYS + OVERRUN];
    public final double[] y = new double[RayColumns.MAX_RAYS + OVERRUN];
    public final double[] z = new double[RayColumns.MAX_RAYS + OVERRUN];
    /** For each row which of the places of a sample is its own, a whole number from 0: kept as lanes choose by it. */
    public final double[] rotation = new double[RayColumns.MAX_RAYS + OVERRUN];
    /** For each row the end of its way; unread where {@link #isOffSurface}. */
    public final ShadowRayTarget[] target = new ShadowRayTarget[RayColumns.MAX_RAYS + OVERRUN];
    /** Whether all ends are {@link ShadowRayTarget#isOffSurface}. */
    public boolean isOffSurface;
    /** Whether they lead to points, at distance 1. */
    public boolean toPoints;

    /** Shapes at this distance or beyond do not block. */
    public double limit() {
        return toPoints ? 1 : Double.POSITIVE_INFINITY;
    }
}
