package lightning.render.trace;

import lightning.render.trace.mesh.LightBuffer;
import lightning.render.trace.primitive.LightBuffers;
import lightning.render.trace.tree.ShadowRayTarget;
import org.jspecify.annotations.Nullable;

/**
 * Shadow rays through clear shapes, from rows of a tile to any samples of one light. They are traced together. Reused; not
 * thread-safe.
 */
public final class ShadowRayBatch {
    /** Maximum number of rays. */
    public static final int MAX_RAYS = 2048;
    /** Lanes may overrun the end by less than this. */
    private static final int OVERRUN = 64;

    /** Origins and directions (any length), render space. */
    public final double[] ox = new double[MAX_RAYS + OVERRUN];
    public final double[] oy = new double[MAX_RAYS + OVERRUN];
    public final double[] oz = new double[MAX_RAYS + OVERRUN];
    public final double[] dx = new double[MAX_RAYS + OVERRUN];
    public final double[] dy = new double[MAX_RAYS + OVERRUN];
    public final double[] dz = new double[MAX_RAYS + OVERRUN];
    /** Row at which each ray starts. */
    public final int[] row = new int[MAX_RAYS];
    /** Index of each ray's target in {@link #targets} and {@link #lightBuffers}. */
    public final int[] targetIndex = new int[MAX_RAYS];
    /** Number of rays. */
    public int count;
    /** True if the rays end at distance 1; otherwise they have no end. */
    public boolean toPoints;
    /** Targets, null if no ray ends on a shape. */
    public ShadowRayTarget @Nullable [] targets;
    /** Light buffers of all targets. They may be set only if {@link #toPoints} is true and no ray ends on a shape. */
    public @Nullable LightBuffers lightBuffers;

    /** Removes all rays. */
    public void clear() {
        count = 0;
    }

    /**
     * Adds a ray, for which there must be room.
     *
     * @param x target point, or direction, with {@code y} and {@code z}
     */
    public void add(HitRows rows, int i, double x, double y, double z, int index) {
        int k = count++;
        ox[k] = rows.px[i];
        oy[k] = rows.py[i];
        oz[k] = rows.pz[i];
        dx[k] = toPoints ? x - ox[k] : x;
        dy[k] = toPoints ? y - oy[k] : y;
        dz[k] = toPoints ? z - oz[k] : z;
        row[k] = i;
        targetIndex[k] = index;
    }

    /** Returns the distance from which shapes do not count. */
    public double limit() {
        return toPoints ? 1 : Double.POSITIVE_INFINITY;
    }

    /** Returns the target of ray {@code k}. */
    ShadowRayTarget target(int k) {
        return targets == null ? ShadowRayTarget.OFF_SURFACE : targets[targetIndex[k]];
    }

    /** Returns the light buffer of ray {@code k} for primitive {@code s}; null if there is none. */
    @Nullable
    LightBuffer lightBuffer(int k, int s) {
        return lightBuffers == null ? null : lightBuffers.get(s, targetIndex[k]);
    }
}
