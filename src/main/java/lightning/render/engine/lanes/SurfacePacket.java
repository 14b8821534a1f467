package lightning.render.engine.lanes;

import lightning.render.trace.primitive.SurfaceHit;

/** Surface data of a packet's hits, one lane each, with the values of {@link SurfaceHit}. */
public final class SurfacePacket {
    final double[] localX = new double[RayPacket.WIDTH];
    final double[] localY = new double[RayPacket.WIDTH];
    final double[] localZ = new double[RayPacket.WIDTH];
    /** Points, offset from the surface, render space. */
    public final float[] px = new float[RayPacket.WIDTH];
    public final float[] py = new float[RayPacket.WIDTH];
    public final float[] pz = new float[RayPacket.WIDTH];
    /** Normals of length 1, facing the incoming ray. */
    public final float[] nx = new float[RayPacket.WIDTH];
    public final float[] ny = new float[RayPacket.WIDTH];
    public final float[] nz = new float[RayPacket.WIDTH];
}
