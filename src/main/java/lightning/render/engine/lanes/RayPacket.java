package lightning.render.engine.lanes;

import lightning.render.trace.solid.LaneRays;
import lightning.render.trace.tree.ShadowRayTarget;

/** Packet of rays, one per lane, with their hits. Reused; not thread-safe. */
public final class RayPacket extends LaneRays {
    /** Distance from which primitives do not block; used only by {@link PacketTracer#findBlocked}. */
    public final double[] limit = new double[WIDTH];
    /** Target of shadow rays to a light, at distance 1; used only by {@link PacketTracer#findBlocked}. */
    public ShadowRayTarget target = ShadowRayTarget.OFF_SURFACE;

    /** Distance of the nearest hit, {@code +∞} for a miss. */
    public final double[] t = new double[WIDTH];
    /** Primitive of the nearest hit, −1 for a miss. */
    public final int[] primitive = new int[WIDTH];
    /** Part of the primitive that was hit. */
    public final int[] part = new int[WIDTH];
    /** As {@link lightning.render.trace.RayColumns#startsAtFacets}. */
    boolean startsAtFacets;
    /** {@link #primitive} during the search, as doubles, to be compared and blended like the distances. */
    final double[] nearestPrimitive = new double[WIDTH];
}
