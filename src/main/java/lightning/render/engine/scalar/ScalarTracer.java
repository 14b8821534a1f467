package lightning.render.engine.scalar;

import lightning.render.trace.CameraRays;
import lightning.render.trace.CrossingWalk;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayColumns;
import lightning.render.trace.RowWays;
import lightning.render.trace.SamplePlaces;
import lightning.render.trace.Tracer;
import lightning.render.trace.Ways;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.RayWalk;
import lightning.render.trace.tree.WayEnd;

/** Traces the rays of a tile one by one: slower than in lanes once these are compiled, and quick from the first ray on. */
final class ScalarTracer implements Tracer {
    private final PrimitiveTable primitives;
    private final RayWalk walk;
    private final Surface surface = new Surface();
    /** Made when it is needed first. */
    private CrossingWalk crossings;

    ScalarTracer(Geometry geometry) {
        primitives = geometry.primitives();
        walk = new RayWalk(geometry.bvh());
    }

    @Override
    public Tracer among(Geometry others) {
        return new ScalarTracer(others);
    }

    @Override
    public void eye(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays) {
        for (int y = 0, ray = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                camera.at(column + x + 0.5, row + y + 0.5, rays.dx, rays.dy, rays.dz, ray++);
            }
        }
    }

    @Override
    public void samples(CameraRays camera, SamplePlaces places, RayColumns rays) {
        for (int ray = 0; ray < places.count(); ray++) {
            camera.at(places.x(ray), places.y(ray), rays.dx, rays.dy, rays.dz, ray);
        }
    }

    @Override
    public void nearest(RayColumns rays, Candidates candidates) {
        walk.leadTo(WayEnd.OPEN);
        for (int ray = 0; ray < rays.count; ray++) {
            walk.enter(rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]);
            rays.primitive[ray] = walk.nearest(candidates);
            rays.t[ray] = walk.distance();
            rays.part[ray] = walk.part();
        }
    }

    @Override
    public void distances(RayColumns rays) {
        walk.leadTo(WayEnd.OPEN);
        for (int ray = 0; ray < rays.count; ray++) {
            int s = rays.primitive[ray];
            if (s >= 0) {
                walk.enter(rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]);
                walk.only(s);
                rays.t[ray] = walk.distance();
                rays.part[ray] = walk.part();
            }
        }
    }

    @Override
    public void surfaces(RayColumns rays, HitRows rows, boolean own) {
        for (int row = 0; row < rays.hits; row++) {
            surface(rays, row);
            rows.px[row] = surface.px;
            rows.py[row] = surface.py;
            rows.pz[row] = surface.pz;
            rows.nx[row] = surface.nx;
            rows.ny[row] = surface.ny;
            rows.nz[row] = surface.nz;
            if (own) {
                own(rays, row);
            }
        }
    }

    @Override
    public void ownPoints(RayColumns rays) {
        for (int row = 0; row < rays.hits; row++) {
            surface(rays, row);
            own(rays, row);
        }
    }

    private void surface(RayColumns rays, int row) {
        int ray = rays.order[row];
        surface.at(primitives, rays.primitive[ray], rays.part[ray], rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray],
                rays.dy[ray],
                rays.dz[ray], rays.t[ray]);
    }

    private void own(RayColumns rays, int row) {
        rays.ownX[row] = surface.ownX;
        rays.ownY[row] = surface.ownY;
        rays.ownZ[row] = surface.ownZ;
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, Ways ways, Candidates candidates, int[] blocked) {
        double x = ways.source().x();
        double y = ways.source().y();
        double z = ways.source().z();
        double limit = ways.limit();
        walk.leadTo(ways.end());
        for (int b = 0, first = 0; first < rows.count; b++, first += WORD) {
            int bits = 0;
            for (int left = chosen[b]; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                double px = rows.px[first + i];
                double py = rows.py[first + i];
                double pz = rows.pz[first + i];
                if (ways.ends()) {
                    walk.enter(px, py, pz, x - px, y - py, z - pz);
                } else {
                    walk.enter(px, py, pz, x, y, z);
                }
                bits |= (walk.blocked(limit, candidates) ? 1 : 0) << i;
            }
            blocked[b] = bits;
        }
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, int[] blocked) {
        double limit = ways.limit();
        walk.leadTo(WayEnd.OPEN);
        for (int b = 0, first = 0; first < rows.count; b++, first += WORD) {
            int bits = 0;
            for (int left = chosen[b]; left != 0; left &= left - 1) {
                int i = first + Integer.numberOfTrailingZeros(left);
                double px = rows.px[i];
                double py = rows.py[i];
                double pz = rows.pz[i];
                if (!ways.open) {
                    walk.leadTo(ways.end[i]);
                }
                if (ways.ends) {
                    walk.enter(px, py, pz, ways.x[i] - px, ways.y[i] - py, ways.z[i] - pz);
                } else {
                    walk.enter(px, py, pz, ways.x[i], ways.y[i], ways.z[i]);
                }
                bits |= (walk.blocked(limit, candidates) ? 1 : 0) << i - first;
            }
            blocked[b] = bits;
        }
    }

    @Override
    public void cross(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, Crossings to) {
        if (crossings == null) {
            crossings = new CrossingWalk(primitives);
        }
        crossings.cross(rows, chosen, ways, candidates, to);
    }

    @Override
    public PointBox box(float[] x, float[] y, float[] z, int from, int to) {
        PointBox box = new PointBox();
        range(x, from, to, box, 0);
        range(y, from, to, box, 1);
        range(z, from, to, box, 2);
        return box;
    }

    private static void range(float[] values, int from, int to, PointBox box, int axis) {
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
