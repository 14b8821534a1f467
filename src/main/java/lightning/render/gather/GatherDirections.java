package lightning.render.gather;

import lightning.base.math.Vec3;
import lightning.render.trace.RayBatch;

/**
 * Directions of the rays by which points gather light: cosine-distributed around the normal by which the point is shaded. Bump maps and
 * vertex normals tilt that normal, so some directions would go below the surface. They are reflected at its plane: the light from above
 * stands for the light that the tilted surface would meet. Holds scratch memory: use one instance per thread.
 */
final class GatherDirections {
    private final DirectionTable table;
    private final RayBatch batch;
    /** Normal of the surface at each point; null where it is that by which the point is shaded. */
    private final Vec3[] normals = new Vec3[RayBatch.MAX_RAYS];
    /** Position of each probed point. */
    private final int[] probed = new int[RayBatch.MAX_RAYS];

    /** @param batch finds the normals of surfaces; its rays are replaced */
    GatherDirections(DirectionTable table, RayBatch batch) {
        this.table = table;
        this.batch = batch;
    }

    /**
     * Finds the normals of the surfaces of some points: the first surface under each point, if it is that of the point.
     *
     * @param which indices of at most 1024 points
     */
    void findNormals(SurfaceColumns points, int[] which, int count) {
        int probes = 0;
        for (int i = 0; i < count; i++) {
            int p = which[i];
            normals[i] = null;
            if (batch.hasShadingNormals(points.primitive[p])) {
                batch.startX[probes] = points.px[p];
                batch.startY[probes] = points.py[p];
                batch.startZ[probes] = points.pz[p];
                batch.directionX[probes] = -points.nx[p];
                batch.directionY[probes] = -points.ny[p];
                batch.directionZ[probes] = -points.nz[p];
                probed[probes++] = i;
            }
        }
        if (probes > 0) {
            batch.traceToFirst(probes);
        }
        for (int probe = 0; probe < probes; probe++) {
            if (batch.primitive(probe) == points.primitive[which[probed[probe]]]) {
                normals[probed[probe]] = batch.geometricNormal(probe);
            }
        }
    }

    /**
     * Writes the directions of a point.
     *
     * @param i   position of the point among those of {@link #findNormals}
     * @param toX receives the components x from {@code at} on, as {@code toY} and {@code toZ}
     */
    void write(SurfaceColumns points, int p, int i, long seed, double[] toX, double[] toY, double[] toZ, int at) {
        table.write(seed, points.nx[p], points.ny[p], points.nz[p], toX, toY, toZ, at);
        Vec3 normal = normals[i];
        for (int ray = at; normal != null && ray < at + table.rays(); ray++) {
            double height = toX[ray] * normal.x() + toY[ray] * normal.y() + toZ[ray] * normal.z();
            if (height < 0) {
                toX[ray] -= 2 * height * normal.x();
                toY[ray] -= 2 * height * normal.y();
                toZ[ray] -= 2 * height * normal.z();
            }
        }
    }
}
