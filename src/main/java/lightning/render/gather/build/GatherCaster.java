package lightning.render.gather.build;

import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.gather.ray.SurfaceNormals;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Casts the rays by which points on surfaces gather light. Holds scratch memory: use one instance per thread. */
final class GatherCaster {
    private final DirectionTable directions;
    private final GlowShapes glows;
    private final RayBatch batch;
    private final SurfaceNormals normals;
    private final CellKeys keys;
    /** Side of the surfel's cell of each row. */
    private final double[] sides = new double[RayBatch.MAX_RAYS];
    /** Directions around one point. */
    private final double[] x;
    private final double[] y;
    private final double[] z;

    GatherCaster(Geometry geometry, Scene scene, Tracer tracer, CellKeys keys, DirectionTable directions, GlowShapes glows) {
        this.glows = glows;
        this.directions = directions;
        this.keys = keys;
        batch = new RayBatch(geometry, scene, tracer);
        normals = new SurfaceNormals(batch);
        x = new double[directions.rays()];
        y = new double[directions.rays()];
        z = new double[directions.rays()];
    }

    /** Writes the normals of the surfaces on which points {@code from … to − 1} lie. */
    void findNormals(RaySources points, int from, int to) {
        normals.find(points, from, to);
    }

    /** Points whose rays are cast together. */
    static int pointsPerBatch(DirectionTable directions) {
        return Math.max(1, RayBatch.MAX_RAYS / directions.rays());
    }

    /**
     * Casts the rays of points {@code from … to − 1}, at most {@link #pointsPerBatch}.
     *
     * @param links          receives the cell that each ray hit
     * @param inverseLengths receives the sum of the {@link InverseLengths} of each point's rays; null if not wanted
     */
    void cast(RaySources points, int from, int to, RayLinks links, long @Nullable [] inverseLengths) {
        int rays = directions.rays();
        for (int p = from; p < to; p++) {
            aim(points, p, (p - from) * rays);
        }
        int count = (to - from) * rays;
        batch.trace(count);
        HitRows rows = batch.rowsWithoutTexels();
        links.clear(from * rays, to * rays);
        for (int row = 0; row < rows.count; row++) {
            int ray = rows.parent[row];
            long key = keys.surfelKey(rows, row, batch.primitive(ray), batch.distance(ray));
            links.setKey(from * rays + ray, key, glows.isAimed(batch.primitive(ray), points.surface, from + ray / rays));
        }
        for (int ray = 0; ray < count; ray++) {
            if (batch.primitive(ray) < 0) {
                links.setMiss(from * rays + ray, batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray]);
            }
        }
        if (batch.isTinted()) {
            links.setTints(from * rays, count, batch.tint, 0);
        }
        if (inverseLengths != null) {
            for (int p = from; p < to; p++) {
                inverseLengths[p] = inverseLengths((p - from) * rays, rays, keys.side(points.surface, p));
            }
        }
    }

    private void aim(RaySources points, int p, int at) {
        points.writeDirections(p, directions, batch.directionX, batch.directionY, batch.directionZ, at);
        for (int ray = at; ray < at + directions.rays(); ray++) {
            points.setStart(p, batch, ray);
        }
    }

    private long inverseLengths(int first, int rays, double side) {
        long sum = 0;
        for (int ray = first; ray < first + rays; ray++) {
            sum += batch.primitive(ray) < 0 ? 0 : InverseLengths.term(batch.distance(ray), side);
        }
        return sum;
    }

    /**
     * Casts some rays again and returns what they hit, with the mean texture colors of the surfels' cells.
     *
     * @param selected indices of the rays, at most 1024, ascending; each hits a surface
     * @param from     first of them
     * @return rows sorted by material; {@code parent} is the position among the selected
     */
    HitRows hits(RaySources points, int[] selected, int from, int to) {
        int rays = directions.rays();
        int known = -1;
        for (int i = from; i < to; i++) {
            int p = selected[i] / rays;
            if (p != known) {
                points.writeDirections(p, directions, x, y, z, 0);
                known = p;
            }
            int k = selected[i] % rays;
            batch.directionX[i - from] = x[k];
            batch.directionY[i - from] = y[k];
            batch.directionZ[i - from] = z[k];
            points.setStart(p, batch, i - from);
        }
        batch.trace(to - from);
        HitRows rows = batch.rows((hits, texels, transparent) -> new HitRows(hits, texels, transparent, false, true));
        for (int row = 0; row < rows.count; row++) {
            sides[row] = keys.surfelSide(rows.px[row], rows.py[row], rows.pz[row], batch.distance(rows.parent[row]));
        }
        batch.writeMeanTexels(rows, sides);
        return rows.compact();
    }
}
