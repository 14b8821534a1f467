package lightning.render.trace.solid;

/** Points on surfaces, lane by lane, in the own space of what they are on. Reused; not shared between threads. */
public final class PointLanes {
    public final double[] localX = new double[RayBatch.WIDTH];
    public final double[] localY = new double[RayBatch.WIDTH];
    public final double[] localZ = new double[RayBatch.WIDTH];
    /** Directions of any length that lead out of the surface. */
    public final double[] outwardX = new double[RayBatch.WIDTH];
    public final double[] outwardY = new double[RayBatch.WIDTH];
    public final double[] outwardZ = new double[RayBatch.WIDTH];
}
