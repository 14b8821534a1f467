package lightning.render.engine.lanes;

import lightning.render.trace.solid.RayBatch;
import lightning.render.trace.tree.ShadowRayTarget;

/**
 * A handful of rays that travel together, one lane each, and what they met. Reused for packet after
 * packet; not shared between threads.
 */
public final class RayPacket extends RayBatch {
    /** Primitives at this distance or beyond do not block; only {@link PacketTracer#findBlocked} asks. */
    public final double[] limit = new double[WIDTH];
    /** Where the ways end at distance 1, if they end at a light; only {@link PacketTracer#findBlocked} asks. */
    public ShadowRayTarget target = ShadowRayTarget.OFF_SURFACE;

    /** The distance of the nearest hit, {@code +∞} for a miss. */
    public final double[] t = new double[WIDTH];
    /** The primitive of the nearest hit, −1 for a miss. */
    public final int[] primitive = new int[WIDTH];
    /** The part of it that was hit. */
    public final int[] part = new int[WIDTH];
    /** {@link #primitive} while it is looked for, as doubles to be compared and blended like the distances. */
    final double[] nearestPrimitive = new double[WIDTH];
}
