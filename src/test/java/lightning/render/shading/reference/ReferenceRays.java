package lightning.render.shading.reference;

import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayColumns;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.RayTraversal;
import lightning.render.trace.tree.ShadowRayTarget;

/** Tracer of single rays for the paths of {@link ReferenceReflections}, independent of the engines. It casts no shadow rays. */
final class ReferenceRays implements Tracer {
    private final Geometry geometry;
    private final RayTraversal traversal;
    private final SurfaceHit surface = new SurfaceHit();

    ReferenceRays(Geometry geometry) {
        this.geometry = geometry;
        traversal = new RayTraversal(geometry.bvh());
    }

    @Override
    public Tracer withGeometry(Geometry other) {
        return new ReferenceRays(other);
    }

    @Override
    public void directEyeRays(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays) {
        for (int ray = 0; ray < columns * lines; ray++) {
            camera.writeDirection(column + ray % columns + 0.5, row + ray / columns + 0.5, rays.dx, rays.dy, rays.dz, ray);
        }
    }

    @Override
    public void directSampleRays(CameraRays camera, SamplePositions positions, RayColumns rays) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void findNearest(RayColumns rays, CandidateList candidates) {
        traversal.setTarget(ShadowRayTarget.OFF_SURFACE);
        for (int ray = 0; ray < rays.count; ray++) {
            start(rays, ray);
            rays.primitive[ray] = traversal.nearest(candidates);
            rays.t[ray] = traversal.distance();
            rays.part[ray] = traversal.part();
        }
    }

    private void start(RayColumns rays, int ray) {
        traversal.setRay(rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]);
    }

    @Override
    public void writeDistances(RayColumns rays) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void writeSurfaces(RayColumns rays, HitRows rows, boolean withLocalPoints) {
        for (int row = 0; row < rays.hitCount; row++) {
            computeSurface(rays, row);
            rows.px[row] = surface.px;
            rows.py[row] = surface.py;
            rows.pz[row] = surface.pz;
            rows.nx[row] = surface.nx;
            rows.ny[row] = surface.ny;
            rows.nz[row] = surface.nz;
            copyLocalPoint(rays, row, withLocalPoints);
        }
    }

    @Override
    public void writeLocalPoints(RayColumns rays) {
        for (int row = 0; row < rays.hitCount; row++) {
            computeSurface(rays, row);
            copyLocalPoint(rays, row, true);
        }
    }

    private void computeSurface(RayColumns rays, int row) {
        int ray = rays.order[row];
        surface.lifts = !rays.startsAtFacets;
        surface.compute(geometry.primitives(), rays.primitive[ray], rays.part[ray], rays.originX(ray), rays.originY(ray), rays.originZ(ray),
                rays.dx[ray], rays.dy[ray], rays.dz[ray], rays.t[ray]);
    }

    private void copyLocalPoint(RayColumns rays, int row, boolean isWanted) {
        if (isWanted) {
            rays.localX[row] = surface.localX;
            rays.localY[row] = surface.localY;
            rays.localZ[row] = surface.localZ;
        }
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, ShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void findHits(ShadowRayBatch rays, CandidateList candidates, ShadowRayHits hits) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void writeHitSurfaces(ShadowRayBatch rays, ShadowRayHits hits) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void exponentials(double[] values, int count) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void setRange(float[] values, int from, int to, PointBox box, int axis) {
        float low = values[from];
        float high = low;
        for (int i = from + 1; i < to; i++) {
            low = Math.min(low, values[i]);
            high = Math.max(high, values[i]);
        }
        box.set(axis, low, high);
    }

    @Override
    public void range(double[] values, int count, double[] range) {
        range[0] = values[0];
        range[1] = values[0];
        for (int i = 1; i < count; i++) {
            range[0] = Math.min(range[0], values[i]);
            range[1] = Math.max(range[1], values[i]);
        }
    }
}
