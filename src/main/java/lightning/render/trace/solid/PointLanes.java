package lightning.render.trace.solid;

/** Points on surfaces, lane by lane, in the own space of what they are on. Reused; not shared between threads. */
public final class PointLanes {
    public final double[] ownX = new double[Rays.WIDTH];
    public final double[] ownY = new double[Rays.WIDTH];
    public final double[] ownZ = new double[Rays.WIDTH];
    /** Directions of any length that lead out of the surface. */
    public final double[] outX = new double[Rays.WIDTH];
    public final double[] outY = new double[Rays.WIDTH];
    public final double[] outZ = new double[Rays.WIDTH];
}
