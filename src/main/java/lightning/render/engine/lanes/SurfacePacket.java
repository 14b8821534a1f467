package lightning.render.engine.lanes;

import lightning.render.trace.primitive.SurfaceHit;

/** The surfaces that a packet's rays met, lane by lane, as {@link SurfaceHit} has them. */
public final class SurfacePacket {
    final double[] localX = new double[RayPacket.WIDTH];
    final double[] localY = new double[RayPacket.WIDTH];
    final double[] localZ = new double[RayPacket.WIDTH];
    /** Points off the surface, render space. */
    public final float[] px = new float[RayPacket.WIDTH];
    public final float[] py = new float[RayPacket.WIDTH];
    public final float[] pz = new float[RayPacket.WIDTH];
    /** Normals of length 1, facing the incoming ray. */
    public final float[] nx = new float[RayPacket.WIDTH];
    public final float[] ny = new float[RayPacket.WIDTH];
    public final float[] nz = new float[RayPacket.WIDTH];
}
