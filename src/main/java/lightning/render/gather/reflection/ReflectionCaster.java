package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowAim;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.SurfaceNormals;
import lightning.render.lobe.RoughLobes;
import lightning.render.lobe.RoughLobes.Kind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.BoxRay;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Casts the rays into which rough surfaces reflect their views. Holds scratch memory: use one instance per thread. */
public final class ReflectionCaster {
    /** Largest width α of lobes that show glowing objects in mirrors. */
    private static final double GLINTS = 0.1;
    /** Maximum number of a point's rays that are aimed at glowing objects. */
    public static final int MAX_AIMED = 16;
    /** Width of a surfel's cell relative to that of the lobe where it meets the surfel. */
    private static final double DETAIL = 0.5;

    private final ReflectionDirections directions;
    private final @Nullable RoughLobes[] lobes;
    private final CellKeys keys;
    private final GlowShapes glows;
    private final GlowAim glowAim;
    /** Rays of a point: those of its lobes, then those aimed at glowing objects. */
    private final int raysPerPoint;
    private final RayBatch batch;
    /** Weights of each ray of the batch and the density of its lobe, per steradian; that of aimed rays is unused. */
    private final double[] color = new double[RayBatch.MAX_RAYS];
    private final double[] white = new double[RayBatch.MAX_RAYS];
    private final double[] density = new double[RayBatch.MAX_RAYS];
    /** Object at which each ray of a batch is aimed; −1 for none. */
    private final int[] aimed = new int[RayBatch.MAX_RAYS];
    private final BoxRay boxRay = new BoxRay();
    private final SurfaceNormals normals;
    private final PointLobes at;
    private final double[] sides = new double[RayBatch.MAX_RAYS];
    /** First of the directions of the present point. */
    private int firstPlace;

    /**
     * @param lobes by material
     * @param glows objects that a picture shows glowing
     */
    public ReflectionCaster(Geometry geometry, Scene scene, Tracer tracer, CellKeys keys, ReflectionDirections directions,
            @Nullable RoughLobes[] lobes, GlowShapes glows) {
        this.glows = glows;
        glowAim = new GlowAim(glows, MAX_AIMED);
        raysPerPoint = raysPerPoint(directions, glows);
        this.directions = directions;
        at = new PointLobes(directions.side);
        this.lobes = lobes;
        this.keys = keys;
        batch = new RayBatch(geometry, scene, tracer, true);
        normals = new SurfaceNormals(batch);
    }

    /** Returns the rays of a point: those of its lobes, and those that may be aimed. */
    public static int raysPerPoint(ReflectionDirections directions, GlowShapes glows) {
        return directions.rays + aimedRays(glows);
    }

    /** Returns the rays of a point that may be aimed at glowing objects. */
    static int aimedRays(GlowShapes glows) {
        return Math.min(MAX_AIMED, 4 * glows.count());
    }

    /** Points whose rays are cast together. */
    int pointsPerBatch() {
        return Math.max(1, RayBatch.MAX_RAYS / raysPerPoint);
    }

    /** Finds the normals of the surfaces of points {@code from … to − 1}, before their rays are cast. */
    void findNormals(ReflectionPoints points, int from, int to) {
        normals.find(points.sources, from, to);
    }

    /** Returns whether any ray of a point may meet something else than before an edit. */
    boolean mayChange(ReflectionPoints points, int p, ReflectionMemo memo) {
        moveTo(points, p);
        SurfaceColumns s = points.surface();
        for (int k = 0; k < raysPerPoint; k++) {
            direct(points, p, k, 0);
            boxRay.setRay(s.px[p], s.py[p], s.pz[p], at.d[0], at.d[1], at.d[2]);
            if (memo.mayChange(boxRay)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Casts the rays of some points.
     *
     * @param selected       numbers of points
     * @param from           first of them whose rays are cast, before {@code to}; at most {@link #pointsPerBatch}
     * @param inverseLengths receives the sum of the {@link InverseLengths} of each point's rays
     */
    void cast(ReflectionPoints points, int[] selected, int from, int to, ReflectionLinks links, long[] inverseLengths) {
        int rays = raysPerPoint;
        for (int i = from; i < to; i++) {
            int p = selected[i];
            moveTo(points, p);
            for (int k = 0; k < rays; k++) {
                direct(points, p, k, (i - from) * rays + k);
            }
            inverseLengths[p] = 0;
            links.clear(p * rays, p * rays + rays);
        }
        int count = (to - from) * rays;
        batch.trace(count);
        HitRows rows = batch.rowsWithoutTexels();
        for (int row = 0; row < rows.count; row++) {
            int ray = rows.parent[row];
            int p = selected[from + ray / rays];
            int linked = p * rays + ray % rays;
            double distance = batch.distance(ray);
            int primitive = batch.primitive(ray);
            int detail = detail(points, p, ray % rays, rows, row, distance);
            long key = keys.surfelKey(rows, row, primitive, distance);
            links.setKeys(linked, key, detail == 0 ? key
                    : keys.detailKey(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], primitive,
                            distance,
                            detail));
            weigh(points, p, ray, ray % rays, primitive);
            if (ray % rays < directions.rays && color[ray] + white[ray] > 0) {
                inverseLengths[p] += InverseLengths.term(distance, keys.side(points.surface(), p));
            }
        }
        for (int ray = 0; ray < count; ray++) {
            int linked = selected[from + ray / rays] * rays + ray % rays;
            boolean counts = ray % rays < directions.rays || batch.primitive(ray) >= 0;
            links.setWeights(linked, counts ? color[ray] : 0, counts ? white[ray] : 0);
            if (batch.primitive(ray) < 0) {
                boolean isOfLobe = ray % rays < directions.rays && !batch.enters[ray] && !batch.hasEntered(ray) && !batch.isMirrored(ray);
                links.setMiss(linked, !isOfLobe ? SkyCells.of(batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray])
                        : batch.directionY[ray] < 0 ? SkyCells.BELOW : SkyCells.ABOVE);
            }
        }
        for (int i = from; i < to && batch.isTinted(); i++) {
            links.setTints(selected[i] * rays, rays, batch.tint, (i - from) * rays);
        }
    }

    /**
     * Changes the weights of a ray that hits a primitive: where both a ray of a lobe and an aimed one may meet a glowing object, each
     * counts by its share of the densities (balance heuristic, E. Veach and L. Guibas, Optimally combining sampling techniques, 1995).
     */
    private void weigh(ReflectionPoints points, int p, int ray, int k, int primitive) {
        int shape = glows.index(primitive);
        if (k >= directions.rays) {
            if (shape < 0 || shape != aimed[ray] || batch.isMirrored(ray)) {
                color[ray] = 0;
                white[ray] = 0;
            }
            return;
        }
        if (shape >= 0 && batch.isMirrored(ray) && alpha(points, p, k) > GLINTS) {
            // Few rays of a wide lobe would meet a lamp in a mirror: bright dots.
            color[ray] = 0;
            white[ray] = 0;
        }
        if (shape < 0 || density[ray] == 0 || batch.isMirrored(ray)) {
            return;
        }
        SurfaceColumns s = points.surface();
        at.d[0] = batch.directionX[ray];
        at.d[1] = batch.directionY[ray];
        at.d[2] = batch.directionZ[ray];
        double angle = Math.PI * glowAim.solidAngle(shape, s.px[p], s.py[p], s.pz[p], at.d);
        if (angle > 0) {
            double own = raysOfLobe(points, p, k) * density[ray] * angle;
            color[ray] *= own / (own + 1);
            white[ray] *= own / (own + 1);
        }
    }

    private int detail(ReflectionPoints points, int p, int k, HitRows rows, int row, double distance) {
        if (k >= directions.rays) {
            return 0;
        }
        double width = lobes(points, p).narrow(kind(points, p, k), alpha(points, p, k));
        return keys.detailLevel(rows.px[row], rows.py[row], rows.pz[row], distance, DETAIL * width * distance);
    }

    private RoughLobes lobes(ReflectionPoints points, int p) {
        return requireNonNull(lobes[points.material[p]]);
    }

    private Kind kind(ReflectionPoints points, int p, int k) {
        return lobes(points, p).kind(k / directions.side, k % directions.side);
    }

    private double alpha(ReflectionPoints points, int p, int k) {
        return PointLobes.alpha(lobes(points, p), kind(points, p, k), points.seen.roughness[p]);
    }

    /** Returns the number of rays of the lobe of ray {@code k} of a point. */
    private int raysOfLobe(ReflectionPoints points, int p, int k) {
        return lobes(points, p).rays(kind(points, p, k), directions.side);
    }

    private void moveTo(ReflectionPoints points, int p) {
        at.moveTo(points, p, lobes(points, p));
        firstPlace = directions.first(points.seed[p]);
    }

    /** Writes ray {@code k} of the present point and its weights to the batch. */
    private void direct(ReflectionPoints points, int p, int k, int ray) {
        SurfaceColumns s = points.surface();
        batch.startX[ray] = s.px[p];
        batch.startY[ray] = s.py[p];
        batch.startZ[ray] = s.pz[p];
        aimed[ray] = -1;
        batch.enters[ray] = false;
        if (k < directions.rays) {
            scatter(points, p, k, ray);
        } else {
            aimAtGlow(points, p, k - directions.rays, ray);
        }
        color[ray] = at.color;
        white[ray] = at.white;
        density[ray] = at.density;
        batch.directionX[ray] = at.d[0];
        batch.directionY[ray] = at.d[1];
        batch.directionZ[ray] = at.d[2];
    }

    /** Chooses the direction of a ray of a lobe. */
    private void scatter(ReflectionPoints points, int p, int k, int ray) {
        Kind kind = at.kind(k);
        int place = firstPlace + k;
        at.scatter(kind, directions.share(place), directions.cos(place), directions.sin(place));
        if (kind == Kind.PASSING) {
            points.sources.turnBelow(p, at.d);
            batch.enters[ray] = true;
        } else if (points.sources.turnAbove(p, at.d)) {
            at.density = 0;
        }
    }

    /** Aims a ray at a glowing object, if the point has so many. */
    private void aimAtGlow(ReflectionPoints points, int p, int number, int ray) {
        SurfaceColumns s = points.surface();
        long seed = points.seed[p];
        double angle = 0;
        int first = 0;
        for (int shape = 0; shape < glows.count() && aimed[ray] < 0; shape++) {
            int toShape = glowAim.rays(shape, seed, s.px[p], s.py[p], s.pz[p]);
            if (number < first + toShape) {
                angle = Math.PI * glowAim.aim(shape, number - first, seed, s.px[p], s.py[p], s.pz[p], at.d);
                aimed[ray] = shape;
            }
            first += toShape;
        }
        at.weigh(aimed[ray] >= 0 && points.sources.isAbove(p, at.d) ? angle : 0);
        if (at.color == 0 && at.white == 0) {
            at.d[0] = s.nx[p];
            at.d[1] = s.ny[p];
            at.d[2] = s.nz[p];
        }
    }

    /**
     * Casts some rays again and returns what they hit, as {@link lightning.render.gather.build.GatherCaster#hits}.
     *
     * @param details whether the rays find parts of surfels
     */
    HitRows hits(ReflectionPoints points, int[] selected, int from, int to, boolean details) {
        int rays = raysPerPoint;
        int known = -1;
        for (int i = from; i < to; i++) {
            int p = selected[i] / rays;
            if (p != known) {
                moveTo(points, p);
                known = p;
            }
            direct(points, p, selected[i] % rays, i - from);
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
