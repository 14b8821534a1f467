package lightning.render.trace.solid;

/** Lane versions of {@link SolidGeometry} for all kinds. Holds scratch memory: use one per thread. */
public final class SolidGeometryLanes {
    private final IntervalHitLanes slab = new IntervalHitLanes();

    /**
     * Writes the distances of {@link SolidGeometry#distance} for the lanes {@code from … to − 1}, whole vectors, to
     * {@code out}.
     */
    public void distances(SolidKind kind, double[] data, int at, LaneRays rays, double[] out, int from, int to) {
        switch (kind) {
            case SPHERE -> SphereLanes.distances(data, at, rays, out, from, to);
            case CYLINDER -> {
                CylinderLanes.writeSideIntervals(data, at, rays, slab, from, to);
                slab.hit(data[at + Frustum.CAPS] != 0, out, from, to);
            }
            case FRUSTUM -> {
                FrustumLanes.writeSideIntervals(data, at, rays, slab, from, to);
                slab.hit(data[at + Frustum.CAPS] != 0, out, from, to);
            }
            case PLANE -> PlaneLanes.distances(data, at, rays, out, from, to);
        }
    }

    /** Writes {@link SolidGeometry#outwardNormal} for the points of one vector, which begins at lane {@code h}. */
    public static void outwardNormals(SolidKind kind, double[] data, int at, PointLanes points, int h) {
        switch (kind) {
            case SPHERE -> SphereLanes.outwardNormals(points, h);
            case CYLINDER -> CylinderLanes.outwardNormals(data, at, points, h);
            case FRUSTUM -> FrustumLanes.outwardNormals(data, at, points, h);
            case PLANE -> PlaneLanes.outwardNormals(points, h);
        }
    }
}
