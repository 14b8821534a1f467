package lightning.render.trace;

import lightning.render.trace.mesh.LightBuffer;
import lightning.render.trace.primitive.LightBuffers;
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

    /**
     * Light buffers of all targets, and the index of pattern 0's target in them; null for none. They may be set only if
     * {@link #toPoints} and {@link #isOffSurface} are true.
     */
    public LightBuffers lightBuffers;
    public int firstTarget;

    /** Returns the light buffer of row {@code i} for primitive {@code s}; null if there is none. */
    public LightBuffer lightBuffer(int i, int s) {
        return lightBuffers == null ? null : lightBuffers.get(s, firstTarget + pattern[i]);
    }

    /** Returns the distance from which shapes do not block. */
    public double limit() {
        return toPoints ? 1 : Double.POSITIVE_INFINITY;
    }
}
