package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.cell.TangentColumns;
import lightning.render.gather.glow.GlowAim;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.SurfaceNormals;
import lightning.render.lobe.CoatShare;
import lightning.render.lobe.ReflectionLobe;
import lightning.render.lobe.RoughLobes;
import lightning.render.lobe.RoughLobes.Kind;
import lightning.render.lobe.SheenDirections;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.BoxRay;
import lightning.scene.Scene;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Casts the rays into which rough surfaces reflect their views. Holds scratch memory: use one instance per thread. */
public final class ReflectionCaster {
    private static final double MIN_COSINE = 1e-3;
    /** Largest width α of lobes that show glowing objects in mirrors. */
    private static final double GLINTS = 0.1;
    /** Width of the lobe that enters a body, which stands for both of its surfaces: variances add up. */
    private static final double TWO_SURFACES = Math.sqrt(2);
    /** Maximum number of a point's rays that are aimed at glowing objects. */
    public static final int MAX_AIMED = 16;
    /** Width of a surfel's cell relative to that of the lobe where it meets the surfel. */
    private static final double DETAIL = 0.5;

    /** Share of the solid angle of a ray: neighboring points have rays in other parts of it, and are mixed ({@link ReflectionFilter}). */
    private static final double SEEN_SHARE = 0.125;

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
    private final double[] d = new double[3];
    private final BoxRay boxRay = new BoxRay();
    private final SurfaceNormals normals;
    private final ReflectionLobe lobe = new ReflectionLobe();
    private final SheenDirections sheen = new SheenDirections();
    private final double[] sides = new double[RayBatch.MAX_RAYS];
    /** Cosine between the view of a point and its normal, the share of its coat, the rays of its rarest lobe, and the first of its directions. */
    private double cosine;
    private double coat;
    private int fewestRays;
    private int firstPlace;
    /** Frame of the point: the plane of normal and view, and the normal. */
    private final double[] tangent = new double[3];
    private final double[] bitangent = new double[3];
    /** Direction of an anisotropic material in this frame. */
    private double turnX;
    private double turnY;

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
        this.lobes = lobes;
        this.keys = keys;
        batch = new RayBatch(geometry, scene, tracer, true);
        normals = new SurfaceNormals(batch);
    }

    /** Returns the rays of a point: those of its lobes, and those that may be aimed. */
    public static int raysPerPoint(ReflectionDirections directions, GlowShapes glows) {
        return directions.rays + Math.min(MAX_AIMED, 4 * glows.count());
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
            boxRay.setRay(s.px[p], s.py[p], s.pz[p], d[0], d[1], d[2]);
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
                links.setMiss(linked, SkyCells.of(batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray],
                        solidAngle(points, selected[from + ray / rays], ray, ray % rays)));
            }
        }
        for (int i = from; i < to && batch.isTinted(); i++) {
            links.setTints(selected[i] * rays, rays, batch.tint, (i - from) * rays);
        }
    }

    /**
     * Returns the solid angle over which a ray of a lobe sees the mean of the environment, steradians: a share of what it stands for
     * (J. Křivánek and M. Colbert, Real-time Shading with Filtered Importance Sampling, 2008). Few rays of the outer part of a lobe would meet
     * a lamp, as bright dots. 0 where the density is unknown.
     */
    private double solidAngle(ReflectionPoints points, int p, int ray, int k) {
        if (density[ray] == 0 || k >= directions.rays) {
            return 0;
        }
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        return SEEN_SHARE / (its.rays(kind(its, k), directions.side) * density[ray]);
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
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        if (shape >= 0 && batch.isMirrored(ray)
                && alpha(points, p, its, kind(its, k)) > GLINTS) {
            // Few rays of a wide lobe would meet a lamp in a mirror: bright dots.
            color[ray] = 0;
            white[ray] = 0;
        }
        if (shape < 0 || density[ray] == 0 || batch.isMirrored(ray)) {
            return;
        }
        SurfaceColumns s = points.surface();
        d[0] = batch.directionX[ray];
        d[1] = batch.directionY[ray];
        d[2] = batch.directionZ[ray];
        double angle = Math.PI * glowAim.solidAngle(shape, s.px[p], s.py[p], s.pz[p], d);
        if (angle > 0) {
            double own = its.rays(kind(its, k), directions.side) * density[ray] * angle;
            color[ray] *= own / (own + 1);
            white[ray] *= own / (own + 1);
        }
    }

    /** Returns the width α of a lobe of a point; 0 if it is smooth. */
    private static double alpha(ReflectionPoints points, int p, RoughLobes its, Kind kind) {
        if (kind == Kind.SHEEN) {
            return RoughLobes.SHEEN_ALPHA;
        }
        double alpha = kind == Kind.COAT ? its.coatAlpha() : its.alpha() == 0 ? 0 : Material.alpha(points.seen.roughness[p]);
        return kind == Kind.PASSING && requireNonNull(its.frost()).ior() != 1 ? Math.min(1, TWO_SURFACES * alpha) : alpha;
    }

    /** Returns the lobe of a ray of a point. */
    private Kind kind(RoughLobes its, int k) {
        return its.kind(k / directions.side, k % directions.side);
    }

    private int detail(ReflectionPoints points, int p, int k, HitRows rows, int row, double distance) {
        if (k >= directions.rays) {
            return 0;
        }
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        double alpha = alpha(points, p, its, kind(its, k));
        return keys.detailLevel(rows.px[row], rows.py[row], rows.pz[row], distance, DETAIL * its.narrow(kind(its, k), alpha) * distance);
    }

    /** Moves to a point: its view lies in the plane of the tangent and the normal. */
    private void moveTo(ReflectionPoints points, int p) {
        SurfaceColumns s = points.surface();
        double nx = s.nx[p];
        double ny = s.ny[p];
        double nz = s.nz[p];
        double view = -(points.seen.vx[p] * nx + points.seen.vy[p] * ny + points.seen.vz[p] * nz);
        cosine = Math.clamp(view, MIN_COSINE, 1);
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        coat = its.coat() == null ? 0 : CoatShare.of(its.coat(), (float) cosine);
        fewestRays = its.fewestRays(directions.side);
        firstPlace = directions.first(points.seed[p]);
        double x = -points.seen.vx[p] - view * nx;
        double y = -points.seen.vy[p] - view * ny;
        double z = -points.seen.vz[p] - view * nz;
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
        if (its.anisotropy() != null) {
            turnTo(points, p, its.anisotropy());
        }
    }

    private void turnTo(ReflectionPoints points, int p, Anisotropy anisotropy) {
        TangentColumns t = points.seen.tangents;
        double x = t.x(p) * tangent[0] + t.y(p) * tangent[1] + t.z(p) * tangent[2];
        double y = t.x(p) * bitangent[0] + t.y(p) * bitangent[1] + t.z(p) * bitangent[2];
        double angle = Math.toRadians(anisotropy.rotation());
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double length = Math.sqrt(x * x + y * y);
        turnX = (cos * x - sin * y) / length;
        turnY = (sin * x + cos * y) / length;
    }

    /** Sets the lobe of a kind at the present point. @param alpha its width α */
    private void aim(RoughLobes its, Kind kind, double alpha) {
        Anisotropy anisotropy = its.anisotropy();
        if (anisotropy == null || kind != Kind.SURFACE) {
            lobe.aim(cosine, alpha);
        } else {
            lobe.aim(cosine, anisotropy.along(alpha), anisotropy.across(alpha), turnX, turnY);
        }
    }

    /** Writes ray {@code k} of the present point and its weights to the batch. */
    private void direct(ReflectionPoints points, int p, int k, int at) {
        SurfaceColumns s = points.surface();
        RoughLobes its = requireNonNull(lobes[points.material[p]]);
        batch.startX[at] = s.px[p];
        batch.startY[at] = s.py[p];
        batch.startZ[at] = s.pz[p];
        color[at] = 0;
        white[at] = 0;
        density[at] = 0;
        aimed[at] = -1;
        batch.enters[at] = false;
        if (k < directions.rays) {
            scatter(points, p, k, at, its);
        } else {
            aimAtGlow(points, p, k - directions.rays, at, its);
        }
        batch.directionX[at] = d[0];
        batch.directionY[at] = d[1];
        batch.directionZ[at] = d[2];
    }

    /** Chooses the direction of a ray of a lobe. */
    private void scatter(ReflectionPoints points, int p, int k, int at, RoughLobes its) {
        Kind kind = kind(its, k);
        int place = firstPlace + k;
        double factor = (double) fewestRays / its.rays(kind, directions.side);
        if (kind == Kind.SHEEN) {
            sheen.aim(requireNonNull(its.fibers()).roughness(), cosine);
            sheen.scatter(directions.share(place), directions.cos(place), directions.sin(place));
            direct(points, p, sheen.x(), sheen.y(), sheen.z());
            density[at] = points.sources.turnAbove(p, d) ? 0 : sheen.density();
            white[at] += factor;
            return;
        }
        aim(its, kind, alpha(points, p, its, kind));
        lobe.reflect(directions.share(place), directions.cos(place), directions.sin(place));
        if (kind == Kind.PASSING) {
            lobe.pass(requireNonNull(its.frost()).ior());
            direct(points, p, lobe.x(), lobe.y(), Math.min(lobe.z(), -lobe.z()));
            points.sources.turnBelow(p, d);
            batch.enters[at] = true;
        } else {
            direct(points, p, lobe.x(), lobe.y(), Math.abs(lobe.z()));
            density[at] = points.sources.turnAbove(p, d) ? 0 : lobe.density();
        }
        addWeights(at, its, kind, factor);
    }

    /** Sets the direction to one in the frame of the point. */
    private void direct(ReflectionPoints points, int p, double x, double y, double z) {
        SurfaceColumns s = points.surface();
        d[0] = x * tangent[0] + y * bitangent[0] + z * s.nx[p];
        d[1] = x * tangent[1] + y * bitangent[1] + z * s.ny[p];
        d[2] = x * tangent[2] + y * bitangent[2] + z * s.nz[p];
    }

    /** Aims a ray at a glowing object, if the point has so many. */
    private void aimAtGlow(ReflectionPoints points, int p, int number, int at, RoughLobes its) {
        SurfaceColumns s = points.surface();
        long seed = points.seed[p];
        d[0] = s.nx[p];
        d[1] = s.ny[p];
        d[2] = s.nz[p];
        int first = 0;
        for (int shape = 0; shape < glows.count(); shape++) {
            int toShape = glowAim.rays(shape, seed, s.px[p], s.py[p], s.pz[p]);
            if (number < first + toShape) {
                double angle = Math.PI * glowAim.aim(shape, number - first, seed, s.px[p], s.py[p], s.pz[p], d);
                aimed[at] = shape;
                double z = d[0] * s.nx[p] + d[1] * s.ny[p] + d[2] * s.nz[p];
                if (angle > 0 && z > 0 && points.sources.isAbove(p, d)) {
                    double x = d[0] * tangent[0] + d[1] * tangent[1] + d[2] * tangent[2];
                    double y = d[0] * bitangent[0] + d[1] * bitangent[1] + d[2] * bitangent[2];
                    addAimed(at, its, Kind.SURFACE, alpha(points, p, its, Kind.SURFACE), x, y, z, angle);
                    addAimed(at, its, Kind.COAT, its.coatAlpha(), x, y, z, angle);
                    addAimedAtSheen(at, its, x, y, z, angle);
                } else {
                    d[0] = s.nx[p];
                    d[1] = s.ny[p];
                    d[2] = s.nz[p];
                }
                return;
            }
            first += toShape;
        }
    }

    /** Adds the weights of an aimed ray for one lobe, relative to those of the rays of the lobe that has the fewest. */
    private void addAimed(int at, RoughLobes its, Kind kind, double alpha, double x, double y, double z, double angle) {
        if (alpha > 0) {
            aim(its, kind, alpha);
            lobe.moveTo(x, y, z);
            double own = lobe.density() * angle;
            addWeights(at, its, kind, fewestRays * own / (its.rays(kind, directions.side) * own + 1));
        }
    }

    private void addAimedAtSheen(int at, RoughLobes its, double x, double y, double z, double angle) {
        if (its.fibers() != null) {
            sheen.aim(its.fibers().roughness(), cosine);
            sheen.moveTo(x, y, z);
            double own = sheen.density() * angle;
            white[at] += fewestRays * own / (its.rays(Kind.SHEEN, directions.side) * own + 1);
        }
    }

    /** Adds the weights of a direction of a lobe. Below a sheen, all have one weight. A frosted surface has one for all that it reflects, and one for what passes it. */
    private void addWeights(int at, RoughLobes its, Kind kind, double factor) {
        double share = factor * lobe.weight();
        if (its.frost() != null) {
            double fresnel = its.frost().f0() + (1 - its.frost().f0()) * lobe.schlick();
            color[at] += kind == Kind.PASSING ? 0 : share * fresnel;
            white[at] += kind == Kind.PASSING ? share * (1 - fresnel) : 0;
        } else if (kind == Kind.COAT) {
            double f0 = requireNonNull(its.coat()).f0();
            (its.fibers() == null ? white : color)[at] += share * its.coat().weight() * (f0 + (1 - f0) * lobe.schlick());
        } else if (its.fibers() != null) {
            double f0 = its.fibers().f0();
            color[at] += share * (1 - coat) * (f0 + (1 - f0) * lobe.schlick());
        } else {
            color[at] += share * (1 - coat) * (1 - lobe.schlick());
            white[at] += share * (1 - coat) * lobe.schlick();
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
