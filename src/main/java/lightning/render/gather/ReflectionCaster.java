package lightning.render.gather;

import static java.util.Objects.requireNonNull;

import lightning.render.lobe.CoatShare;
import lightning.render.lobe.ReflectionLobe;
import lightning.render.lobe.RoughLobes;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Casts the rays into which rough surfaces reflect their views. Holds scratch memory: use one instance per thread. */
final class ReflectionCaster {
    private static final double MIN_COSINE = 1e-3;
    /** Width of a surfel's cell relative to that of the lobe where it meets the surfel. */
    private static final double DETAIL = 0.5;

    private final ReflectionDirections directions;
    private final @Nullable RoughLobes[] lobes;
    private final CellKeys keys;
    private final RayBatch batch;
    private final SurfaceNormals normals;
    private final ReflectionLobe lobe = new ReflectionLobe();
    private final double[] sides = new double[RayBatch.MAX_RAYS];
    /** Frame of a point: the plane of normal and view, and the normal. */
    private final double[] tangent = new double[3];
    private final double[] bitangent = new double[3];

    /** @param lobes by material */
    ReflectionCaster(Geometry geometry, Scene scene, Tracer tracer, CellKeys keys, ReflectionDirections directions,
            @Nullable RoughLobes[] lobes) {
        this.directions = directions;
        this.lobes = lobes;
        this.keys = keys;
        batch = new RayBatch(geometry, scene, tracer);
        normals = new SurfaceNormals(batch);
    }

    /** Points whose rays are cast together. */
    int pointsPerBatch() {
        return Math.max(1, RayBatch.MAX_RAYS / directions.rays);
    }

    /**
     * Casts the rays of points {@code from … to − 1}, at most {@link #pointsPerBatch}.
     *
     * @param inverseLengths receives the sum of the {@link InverseLengths} of each point's rays
     */
    void cast(ReflectionPoints points, int from, int to, ReflectionLinks links, long[] inverseLengths) {
        normals.find(points.sources, from, to);
        int rays = directions.rays;
        for (int p = from; p < to; p++) {
            aim(points, p);
            for (int k = 0; k < rays; k++) {
                direct(points, p, k, (p - from) * rays + k, links);
            }
            inverseLengths[p] = 0;
        }
        int count = (to - from) * rays;
        batch.trace(count);
        HitRows rows = batch.rowsWithoutTexels();
        links.clear(from * rays, to * rays);
        for (int row = 0; row < rows.count; row++) {
            int ray = rows.parent[row];
            int p = from + ray / rays;
            double distance = batch.distance(ray);
            int primitive = batch.primitive(ray);
            int detail = detail(points, p, ray % rays, rows, row, distance);
            long key = keys.surfelKey(rows, row, primitive, distance);
            links.setKeys(from * rays + ray, key, detail == 0 ? key
                    : keys.detailKey(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], primitive,
                            distance,
                            detail));
            if (links.hasWeight(from * rays + ray)) {
                inverseLengths[p] += InverseLengths.term(distance, keys.side(points.surface(), p));
            }
        }
        for (int ray = 0; ray < count; ray++) {
            if (batch.primitive(ray) < 0) {
                links.setMiss(from * rays + ray, SkyCells.of(batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray]));
            }
        }
        if (batch.isTinted()) {
            links.setTints(from * rays, count, batch.tint);
        }
    }

    private int detail(ReflectionPoints points, int p, int k, HitRows rows, int row, double distance) {
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        double alpha = its.isOfCoat(k) ? its.coatAlpha() : its.alpha();
        return keys.detailLevel(rows.px[row], rows.py[row], rows.pz[row], distance, DETAIL * alpha * distance);
    }

    /** Computes the frame of a point: its view lies in the plane of the tangent and the normal. */
    private void aim(ReflectionPoints points, int p) {
        SurfaceColumns s = points.surface();
        double nx = s.nx[p];
        double ny = s.ny[p];
        double nz = s.nz[p];
        double cosine = -(points.seen.vx[p] * nx + points.seen.vy[p] * ny + points.seen.vz[p] * nz);
        double x = -points.seen.vx[p] - cosine * nx;
        double y = -points.seen.vy[p] - cosine * ny;
        double z = -points.seen.vz[p] - cosine * nz;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 1e-6)) {
            // Any direction along the surface: the axis that is farthest from the normal.
            boolean isFlat = Math.abs(nx) < 0.6;
            x = isFlat ? 1 - nx * nx : -ny * nx;
            y = isFlat ? -nx * ny : 1 - ny * ny;
            z = isFlat ? -nx * nz : -ny * nz;
            length = Math.sqrt(x * x + y * y + z * z);
        }
        tangent[0] = x / length;
        tangent[1] = y / length;
        tangent[2] = z / length;
        bitangent[0] = ny * tangent[2] - nz * tangent[1];
        bitangent[1] = nz * tangent[0] - nx * tangent[2];
        bitangent[2] = nx * tangent[1] - ny * tangent[0];
    }

    /**
     * Writes a ray.
     *
     * @param links receives its weights; null if they are known
     */
    private void direct(ReflectionPoints points, int p, int k, int at, @Nullable ReflectionLinks links) {
        SurfaceColumns s = points.surface();
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        boolean isCoat = its.isOfCoat(k);
        double cosine =
                -(points.seen.vx[p] * (double) s.nx[p] + points.seen.vy[p] * (double) s.ny[p] + points.seen.vz[p] * (double) s.nz[p]);
        cosine = Math.clamp(cosine, MIN_COSINE, 1);
        lobe.aim(cosine, isCoat ? its.coatAlpha() : its.alpha());
        int place = directions.first(points.seed[p]) + k;
        lobe.reflect(directions.share(place), directions.cos(place), directions.sin(place));
        double z = lobe.z() < 0 ? -lobe.z() : lobe.z();
        double[] d = new double[3];
        d[0] = lobe.x() * tangent[0] + lobe.y() * bitangent[0] + z * s.nx[p];
        d[1] = lobe.x() * tangent[1] + lobe.y() * bitangent[1] + z * s.ny[p];
        d[2] = lobe.x() * tangent[2] + lobe.y() * bitangent[2] + z * s.nz[p];
        points.sources.turnAbove(p, d);
        batch.directionX[at] = d[0];
        batch.directionY[at] = d[1];
        batch.directionZ[at] = d[2];
        batch.startX[at] = s.px[p];
        batch.startY[at] = s.py[p];
        batch.startZ[at] = s.pz[p];
        if (links != null) {
            double coat = its.coat() == null ? 0 : CoatShare.of(its.coat(), (float) cosine);
            double share = its.areTwo() ? 2 * lobe.weight() : lobe.weight();
            if (isCoat) {
                double f0 = requireNonNull(its.coat()).f0();
                links.setWeights(p * directions.rays + k, 0, share * its.coat().weight() * (f0 + (1 - f0) * lobe.schlick()));
            } else {
                links.setWeights(p * directions.rays + k, share * (1 - coat) * (1 - lobe.schlick()), share * (1 - coat) * lobe.schlick());
            }
        }
    }

    /**
     * Casts some rays again and returns what they hit, as {@link GatherCaster#hits}.
     *
     * @param details whether the rays find parts of surfels
     */
    HitRows hits(ReflectionPoints points, int[] selected, int from, int to, boolean details) {
        int rays = directions.rays;
        int known = -1;
        for (int i = from; i < to; i++) {
            int p = selected[i] / rays;
            if (p != known) {
                aim(points, p);
                known = p;
            }
            direct(points, p, selected[i] % rays, i - from, null);
        }
        batch.trace(to - from);
        HitRows rows = batch.rows((hits, texels, transparent) -> new HitRows(hits, texels, transparent, false, true));
        for (int row = 0; row < rows.count; row++) {
            int ray = selected[from + rows.parent[row]];
            double distance = batch.distance(rows.parent[row]);
            double side = keys.surfelSide(rows.px[row], rows.py[row], rows.pz[row], distance);
            sides[row] = details ? Math.scalb(side, -detail(points, ray / rays, ray % rays, rows, row, distance)) : side;
        }
        batch.writeMeanTexels(rows, sides);
        return rows.compact();
    }
}
