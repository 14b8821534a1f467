package lightning.render.trace;

import lightning.render.trace.mesh.LightBuffer;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.ShadowRayTarget;

/** Scalar implementation of {@link Tracer#findHits}, one shadow ray at a time. Holds scratch memory: use one per thread. */
public final class ShadowRayHitFinder {
    private final PrimitiveTable primitives;
    private final BoxRay boxRay = new BoxRay();
    private final MeshRayQuery probe = new MeshRayQuery();

    public ShadowRayHitFinder(PrimitiveTable primitives) {
        this.primitives = primitives;
    }

    /** Finds the hits of the shadow rays from selected rows. */
    public void findHits(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, ShadowRayHits hits) {
        double limit = shadowRays.limit();
        for (int b = 0, first = 0; first < rows.count; b++, first += Tracer.ROWS_PER_WORD) {
            for (int left = selected[b]; left != 0; left &= left - 1) {
                int i = first + Integer.numberOfTrailingZeros(left);
                double x = rows.px[i];
                double y = rows.py[i];
                double z = rows.pz[i];
                double dx = shadowRays.toPoints ? shadowRays.x[i] - x : shadowRays.x[i];
                double dy = shadowRays.toPoints ? shadowRays.y[i] - y : shadowRays.y[i];
                double dz = shadowRays.toPoints ? shadowRays.z[i] - z : shadowRays.z[i];
                ShadowRayTarget target = shadowRays.isOffSurface ? ShadowRayTarget.OFF_SURFACE : shadowRays.target[i];
                hits.selectRay(i);
                boxRay.setRay(x, y, z, dx, dy, dz);
                for (int c = 0; c < candidates.count; c++) {
                    if (boxRay.hits(candidates.boxes, 6 * c, limit)) {
                        int s = candidates.primitive[c];
                        LightBuffer buffer = shadowRays.lightBuffer(i, s);
                        if (buffer != null) {
                            primitives.addHits(s, x, y, z, dx, dy, dz, buffer, probe, hits);
                        } else {
                            int index = target.indexOf(s);
                            boolean endsOnPrimitive = index >= 0 && target.touches(index, x, y, z);
                            primitives.addHits(s, x, y, z, dx, dy, dz, endsOnPrimitive, limit, probe, false, hits);
                        }
                    }
                }
            }
        }
    }

    /** Adds the hits of one shadow ray, which does not end on primitive {@code s}, on that primitive. */
    public void findHits(int s, double ox, double oy, double oz, double dx, double dy, double dz, double limit, ShadowRayHits hits) {
        primitives.addHits(s, ox, oy, oz, dx, dy, dz, false, limit, probe, false, hits);
    }
}
