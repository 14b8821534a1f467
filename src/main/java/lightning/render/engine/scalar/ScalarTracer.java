package lightning.render.engine.scalar;

import static java.util.Objects.requireNonNull;

import lightning.base.math.PowerFunction;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayColumns;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.ShadowRayHitFinder;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.RayTraversal;
import lightning.render.trace.tree.ShadowRayTarget;
import org.jspecify.annotations.Nullable;

/** Tracer of single rays: slower than lanes once these are compiled, and fast from the first ray on. */
final class ScalarTracer implements Tracer {
    private final PrimitiveTable primitives;
    private final RayTraversal traversal;
    private final SurfaceHit surface = new SurfaceHit();
    /** Created on first use. */
    private @Nullable ShadowRayHitFinder hitFinder;

    ScalarTracer(Geometry geometry) {
        primitives = geometry.primitives();
        traversal = new RayTraversal(geometry.bvh());
    }

    @Override
    public Tracer withGeometry(Geometry geometry) {
        return new ScalarTracer(geometry);
    }

    @Override
    public void directEyeRays(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays) {
        for (int y = 0, ray = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                camera.writeDirection(column + x + 0.5, row + y + 0.5, rays.dx, rays.dy, rays.dz, ray++);
            }
        }
    }

    @Override
    public void directSampleRays(CameraRays camera, SamplePositions positions, RayColumns rays) {
        for (int ray = 0; ray < positions.count(); ray++) {
            camera.writeDirection(positions.x(ray), positions.y(ray), rays.dx, rays.dy, rays.dz, ray);
        }
    }

    @Override
    public void findNearest(RayColumns rays, CandidateList candidates) {
        traversal.setTarget(ShadowRayTarget.OFF_SURFACE);
        for (int ray = 0; ray < rays.count; ray++) {
            traversal.setRay(rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]);
            rays.primitive[ray] = traversal.nearest(candidates);
            rays.t[ray] = traversal.distance();
            rays.part[ray] = traversal.part();
        }
    }

    @Override
    public void writeDistances(RayColumns rays) {
        traversal.setTarget(ShadowRayTarget.OFF_SURFACE);
        for (int ray = 0; ray < rays.count; ray++) {
            int s = rays.primitive[ray];
            if (s >= 0) {
                traversal.setRay(rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]);
                traversal.intersectPrimitive(s);
                rays.t[ray] = traversal.distance();
                rays.part[ray] = traversal.part();
            }
        }
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
            if (withLocalPoints) {
                copyLocalPoint(rays, row);
            }
        }
    }

    @Override
    public void writeLocalPoints(RayColumns rays) {
        for (int row = 0; row < rays.hitCount; row++) {
            computeSurface(rays, row);
            copyLocalPoint(rays, row);
        }
    }

    private void computeSurface(RayColumns rays, int row) {
        int ray = rays.order[row];
        surface.lifts = !rays.startsAtFacets;
        surface.compute(primitives, rays.primitive[ray], rays.part[ray], rays.originX(ray), rays.originY(ray), rays.originZ(ray),
                rays.dx[ray],
                rays.dy[ray],
                rays.dz[ray], rays.t[ray]);
    }

    private void copyLocalPoint(RayColumns rays, int row) {
        rays.localX[row] = surface.localX;
        rays.localY[row] = surface.localY;
        rays.localZ[row] = surface.localZ;
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, ShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        double x = shadowRays.source().x();
        double y = shadowRays.source().y();
        double z = shadowRays.source().z();
        double limit = shadowRays.limit();
        traversal.setTarget(shadowRays.target());
        for (int b = 0, first = 0; first < rows.count; b++, first += ROWS_PER_WORD) {
            int bits = 0;
            for (int left = selected[b]; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                double px = rows.px[first + i];
                double py = rows.py[first + i];
                double pz = rows.pz[first + i];
                if (shadowRays.isPoint()) {
                    traversal.setRay(px, py, pz, x - px, y - py, z - pz);
                } else {
                    traversal.setRay(px, py, pz, x, y, z);
                }
                bits |= (traversal.isBlocked(limit, candidates) ? 1 : 0) << i;
            }
            blocked[b] = bits;
        }
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        double limit = shadowRays.limit();
        traversal.setTarget(ShadowRayTarget.OFF_SURFACE);
        for (int b = 0, first = 0; first < rows.count; b++, first += ROWS_PER_WORD) {
            int bits = 0;
            for (int left = selected[b]; left != 0; left &= left - 1) {
                int i = first + Integer.numberOfTrailingZeros(left);
                double px = rows.px[i];
                double py = rows.py[i];
                double pz = rows.pz[i];
                if (!shadowRays.isOffSurface) {
                    traversal.setTarget(shadowRays.target[i]);
                }
                if (shadowRays.toPoints) {
                    traversal.setRay(px, py, pz, shadowRays.x[i] - px, shadowRays.y[i] - py, shadowRays.z[i] - pz);
                } else {
                    traversal.setRay(px, py, pz, shadowRays.x[i], shadowRays.y[i], shadowRays.z[i]);
                }
                bits |= (traversal.isBlocked(limit, candidates) ? 1 : 0) << i - first;
            }
            blocked[b] = bits;
        }
    }

    @Override
    public void findHits(ShadowRayBatch rays, CandidateList candidates, ShadowRayHits hits) {
        if (hitFinder == null) {
            hitFinder = new ShadowRayHitFinder(primitives);
        }
        hitFinder.findHits(rays, candidates, hits);
    }

    @Override
    public void writeHitSurfaces(ShadowRayBatch rays, ShadowRayHits hits) {
        requireNonNull(hitFinder).writeSurfaces(rays, hits, 0, hits.count());
    }

    @Override
    public void exponentials(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            values[i] = PowerFunction.exponential(values[i]);
        }
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
