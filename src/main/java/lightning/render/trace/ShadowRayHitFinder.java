package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.mesh.LightBuffer;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.material.Transmission;

/** Scalar implementation of {@link Tracer#findHits}, one shadow ray at a time. Holds scratch memory: use one per thread. */
public final class ShadowRayHitFinder {
    private final PrimitiveTable primitives;
    private final BoxRay boxRay = new BoxRay();
    private final MeshRayQuery probe = new MeshRayQuery();
    private final SurfaceHit surface = new SurfaceHit();

    public ShadowRayHitFinder(PrimitiveTable primitives) {
        this.primitives = primitives;
    }

    /** Finds the hits of all shadow rays. */
    public void findHits(ShadowRayBatch rays, CandidateList candidates, ShadowRayHits hits) {
        double limit = rays.limit();
        for (int k = 0; k < rays.count; k++) {
            double x = rays.ox[k];
            double y = rays.oy[k];
            double z = rays.oz[k];
            double dx = rays.dx[k];
            double dy = rays.dy[k];
            double dz = rays.dz[k];
            ShadowRayTarget target = rays.target(k);
            hits.selectRay(k);
            boxRay.setRay(x, y, z, dx, dy, dz);
            for (int c = 0; c < candidates.count; c++) {
                if (boxRay.hits(candidates.boxes, 6 * c, limit)) {
                    int s = candidates.primitive[c];
                    LightBuffer buffer = rays.lightBuffer(k, s);
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

    /** Adds the hits of one shadow ray, which does not end on primitive {@code s}, on that primitive. */
    public void findHits(int s, ShadowRayBatch rays, int k, ShadowRayHits hits) {
        hits.selectRay(k);
        primitives.addHits(s, rays.ox[k], rays.oy[k], rays.oz[k], rays.dx[k], rays.dy[k], rays.dz[k], false, rays.limit(), probe, false,
                hits);
    }

    /** Writes the surfaces of the hits {@code from … to − 1}, as {@link Tracer#writeHitSurfaces}. */
    public void writeSurfaces(ShadowRayBatch rays, ShadowRayHits hits, int from, int to) {
        for (int i = from; i < to; i++) {
            int k = hits.ray[i];
            double dx = rays.dx[k];
            double dy = rays.dy[k];
            double dz = rays.dz[k];
            Transmission clarity = requireNonNull(primitives.shadowTint(hits.primitive[i])).transmission();
            surface.computeNormal(primitives, hits.primitive[i], hits.part[i], rays.ox[k], rays.oy[k], rays.oz[k], dx, dy, dz, hits.t[i]);
            double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
            hits.inside[i] = surface.isInside();
            hits.reflectance[i] = Refraction.fresnelReflectance(clarity, false, surface.nx, surface.ny, surface.nz, (float) (dx / length),
                    (float) (dy / length), (float) (dz / length));
        }
    }
}
