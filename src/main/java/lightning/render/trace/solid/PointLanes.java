package lightning.render.trace.solid;

/** Points on surfaces, one per lane, in local coordinates of their primitives. Reused; not thread-safe. */
public final class PointLanes {
    public final double[] localX = new double[LaneRays.WIDTH];
    public final double[] localY = new double[LaneRays.WIDTH];
    public final double[] localZ = new double[LaneRays.WIDTH];
    /** Outward directions of the surface, of any length. */
    public final double[] outwardX = new double[LaneRays.WIDTH];
    public final double[] outwardY = new double[LaneRays.WIDTH];
    public final double[] outwardZ = new double[LaneRays.WIDTH];
}
