package lightning.render.trace;

import lightning.render.trace.tree.ShadowRayTarget;

/** Shadow rays of a tile's rows to a light with a separate target point or direction for each row. Reused; not thread-safe. */
public final class RowShadowRays {
    /** Lanes may overrun the end of a column by less than this. */
    private static final int OVERRUN = 64;

    /** Target point, or direction of any length but 0, of each row, up to the next multiple of 16 rows; render space. */
    public final double[] x = new double[RayColumns.MAX_RAYS + OVERRUN];
    public final double[] y = new double[RayColumns.MAX_RAYS + OVERRUN];
    public final double[] z = new double[RayColumns.MAX_RAYS + OVERRUN];
    /** Index of the sample pattern that each row uses, from 0. */
    public final int[] pattern = new int[RayColumns.MAX_RAYS + OVERRUN];
    /** The same patterns as doubles, for the lanes. */
    public final double[] patternLanes = new double[RayColumns.MAX_RAYS + OVERRUN];
    /** Shadow ray target of each row; unused if {@link #isOffSurface}. */
    public final ShadowRayTarget[] target = new ShadowRayTarget[RayColumns.MAX_RAYS + OVERRUN];
    /** True if all targets are {@link ShadowRayTarget#isOffSurface}. */
    public boolean isOffSurface;
    /** True for target points, at distance 1. */
    public boolean toPoints;

    /** Returns the distance from which shapes do not block. */
    public double limit() {
        return toPoints ? 1 : Double.POSITIVE_INFINITY;
    }
}
