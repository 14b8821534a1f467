package lightning.engine.scalar;

import lightning.trace.CameraRays;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.RayColumns;
import lightning.trace.RowWays;
import lightning.trace.SamplePlaces;
import lightning.trace.Tracer;
import lightning.trace.Ways;
import lightning.trace.primitive.Crossings;
import lightning.trace.primitive.PrimitiveTable;
import lightning.trace.solid.Form;
import lightning.trace.tree.Candidates;
import lightning.trace.tree.PointBox;
import lightning.trace.tree.RayWalk;
import lightning.trace.tree.WayEnd;

/**
 * Mends what a tracer finds that knows of no holes, ray by ray: where a ray meets a surface that has holes, and there is one, it goes on.
 * What that tracer finds where there is none is right, as what it finds of any shape is no farther off than what is there of it; and a way
 * that it finds free is free.
 */
public final class HoledTracer implements Tracer {
    private final Tracer whole;
    private final Tracer plain;
    private final PrimitiveTable primitives;
    private final RayWalk walk;

    /** @param whole finds what rays would meet if nothing had holes */
    public HoledTracer(Geometry geometry, Tracer whole) {
        this.whole = whole;
        plain = new ScalarTracer(geometry);
        primitives = geometry.primitives();
        walk = new RayWalk(geometry.bvh());
    }

    @Override
    public Tracer among(Geometry others) {
        return new HoledTracer(others, whole.among(others));
    }

    @Override
    public void eye(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays) {
        whole.eye(camera, column, row, columns, lines, rays);
    }

    @Override
    public void samples(CameraRays camera, SamplePlaces places, RayColumns rays) {
        whole.samples(camera, places, rays);
    }

    @Override
    public void nearest(RayColumns rays, Candidates candidates) {
        whole.nearest(rays, candidates);
        for (int ray = 0; ray < rays.count; ray++) {
            if (finds(rays, ray)) {
                enter(rays, ray);
                rays.primitive[ray] = walk.nearest(candidates);
                write(rays, ray);
            }
        }
    }

    /** Whether a ray finds a hole where it meets a surface. */
    private boolean finds(RayColumns rays, int ray) {
        int s = rays.primitive[ray];
        return s >= 0 && primitives.hasHoles(s) && rays.t[ray] < Form.MISS && primitives.holes(s, rays.originX(ray), rays.originY(ray),
                rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]).passes(rays.part[ray], rays.t[ray]);
    }

    private void enter(RayColumns rays, int ray) {
        walk.leadTo(WayEnd.OPEN);
        walk.enter(rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray], rays.dy[ray], rays.dz[ray]);
    }

    private void write(RayColumns rays, int ray) {
        rays.t[ray] = walk.distance();
        rays.part[ray] = walk.part();
    }

    @Override
    public void distances(RayColumns rays) {
        whole.distances(rays);
        for (int ray = 0; ray < rays.count; ray++) {
            if (finds(rays, ray)) {
                enter(rays, ray);
                walk.only(rays.primitive[ray]);
                write(rays, ray);
            }
        }
    }

    @Override
    public void surfaces(RayColumns rays, HitRows rows, boolean own) {
        whole.surfaces(rays, rows, own);
    }

    @Override
    public void ownPoints(RayColumns rays) {
        whole.ownPoints(rays);
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, Ways ways, Candidates candidates, int[] blocked) {
        whole.blocked(rows, chosen, ways, candidates, blocked);
        if (mayPass(candidates)) {
            plain.blocked(rows, blocked.clone(), ways, candidates, blocked);
        }
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, int[] blocked) {
        whole.blocked(rows, chosen, ways, candidates, blocked);
        if (mayPass(candidates)) {
            plain.blocked(rows, blocked.clone(), ways, candidates, blocked);
        }
    }

    @Override
    public void cross(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, Crossings to) {
        whole.cross(rows, chosen, ways, candidates, to);
    }

    private boolean mayPass(Candidates candidates) {
        boolean any = candidates.tooMany;
        for (int c = 0; c < candidates.count && !any; c++) {
            any = primitives.hasHoles(candidates.primitive[c]);
        }
        return any;
    }

    @Override
    public PointBox box(float[] x, float[] y, float[] z, int from, int to) {
        return whole.box(x, y, z, from, to);
    }

    @Override
    public void range(double[] values, int count, double[] range) {
        whole.range(values, count, range);
    }
}
