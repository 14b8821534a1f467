package lightning.render.trace.solid;

/** The {@link Form} of each kind in lanes. Holds scratch memory: one for each thread. */
public final class KindLanes {
    private final SlabLanes slab = new SlabLanes();

    /** {@link Form#distance}: writes the distances of the lanes {@code from … to − 1}, whole vectors, to {@code out}. */
    public void distances(Kind kind, double[] data, int at, Rays rays, double[] out, int from, int to) {
        switch (kind) {
            case SPHERE -> SphereLanes.distances(data, at, rays, out, from, to);
            case CYLINDER -> {
                CylinderLanes.side(data, at, rays, slab, from, to);
                met(data, at, out, from, to);
            }
            case FRUSTUM -> {
                FrustumLanes.side(data, at, rays, slab, from, to);
                met(data, at, out, from, to);
            }
            case PLANE -> PlaneLanes.distances(data, at, rays, out, from, to);
        }
    }

    private void met(double[] data, int at, double[] out, int from, int to) {
        if (data[at + Frustum.CAPS] != 0) {
            slab.withinSlab(out, from, to);
        } else {
            slab.betweenRims(out, from, to);
        }
    }

    /** {@link Form#outward} for the points of one vector, which begins at lane {@code h}. */
    public static void outward(Kind kind, double[] data, int at, PointLanes points, int h) {
        switch (kind) {
            case SPHERE -> SphereLanes.outward(points, h);
            case CYLINDER -> CylinderLanes.outward(data, at, points, h);
            case FRUSTUM -> FrustumLanes.outward(data, at, points, h);
            case PLANE -> PlaneLanes.outward(points, h);
        }
    }
}
