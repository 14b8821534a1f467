package lightning.render.gather.ray;

import lightning.base.math.Vec3;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.RayBatch;

/**
 * Finds the surfaces under points that are shaded by other normals. Vertex normals lift such points above their surfaces, where two objects
 * touch even into the other one, so that rays from there would see what is behind it. Holds scratch memory: use one instance per thread.
 */
public final class SurfaceNormals {
    /** Surfaces that may be between a lifted point and its own. */
    private static final int MAX_SURFACES = 3;

    private final RayBatch batch;
    /** Point of each probe. */
    private final int[] probed = new int[RayBatch.MAX_RAYS];
    private int count;

    /** @param batch its rays are replaced */
    public SurfaceNormals(RayBatch batch) {
        this.batch = batch;
    }

    /** Writes the surfaces of points {@code from … to − 1}: the first ones of their own primitives under them. */
    public void find(RaySources points, int from, int to) {
        SurfaceColumns surface = points.surface;
        for (int p = from; p < to; p++) {
            points.setUntilted(p);
            if (batch.hasShadingNormals(surface.primitive[p])) {
                batch.startX[count] = surface.px[p];
                batch.startY[count] = surface.py[p];
                batch.startZ[count] = surface.pz[p];
                batch.directionX[count] = -surface.nx[p];
                batch.directionY[count] = -surface.ny[p];
                batch.directionZ[count] = -surface.nz[p];
                probed[count++] = p;
                if (count == RayBatch.MAX_RAYS) {
                    flush(points);
                }
            }
        }
        flush(points);
    }

    private void flush(RaySources points) {
        for (int passed = 0; passed <= MAX_SURFACES && count > 0; passed++) {
            batch.traceToFirst(count);
            int left = 0;
            for (int probe = 0; probe < count; probe++) {
                int p = probed[probe];
                if (batch.primitive(probe) == points.surface.primitive[p]) {
                    Vec3 normal = batch.moveToSurface(probe);
                    if (normal != null) {
                        points.setFacet(p, normal, batch.startX[probe], batch.startY[probe], batch.startZ[probe]);
                    }
                } else if (batch.primitive(probe) >= 0) {
                    batch.moveBehind(probe, left);
                    probed[left++] = p;
                }
            }
            count = left;
        }
        count = 0;
    }
}
