package lightning.render.gather.ray;

import lightning.base.math.Vec3;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.RayBatch;

/** Finds the normals of the surfaces on which points lie. Holds scratch memory: use one instance per thread. */
public final class SurfaceNormals {
    private final RayBatch batch;
    /** Point of each probe. */
    private final int[] probed = new int[RayBatch.MAX_RAYS];
    private int count;

    /** @param batch its rays are replaced */
    public SurfaceNormals(RayBatch batch) {
        this.batch = batch;
    }

    /** Writes the normals of points {@code from … to − 1}: those of the first surfaces under them, if these are the points' own. */
    public void find(RaySources points, int from, int to) {
        SurfaceColumns surface = points.surface;
        for (int p = from; p < to; p++) {
            points.geometricX[p] = Float.NaN;
            points.geometricY[p] = Float.NaN;
            points.geometricZ[p] = Float.NaN;
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
        if (count > 0) {
            batch.traceToFirst(count);
        }
        for (int probe = 0; probe < count; probe++) {
            int p = probed[probe];
            Vec3 normal = batch.primitive(probe) == points.surface.primitive[p] ? batch.geometricNormal(probe) : null;
            if (normal != null) {
                points.geometricX[p] = (float) normal.x();
                points.geometricY[p] = (float) normal.y();
                points.geometricZ[p] = (float) normal.z();
            }
        }
        count = 0;
    }
}
