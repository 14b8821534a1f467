package lightning.render.gather.build;

import java.util.BitSet;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.KnownRays;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.BoxRay;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Repeats the rays of points after an edit: takes those that cannot differ from a memo, and casts the others. Holds scratch memory: use
 * one instance per thread.
 */
final class MemoCaster {
    private final PathMemo memo;
    private final CellKeys keys;
    private final DirectionTable directions;
    private final GlowShapes glows;
    private final RayBatch now;
    private final RayBatch before;
    private final BoxRay boxRay = new BoxRay();
    private final double[] x;
    private final double[] y;
    private final double[] z;
    /** Rays to cast in the present geometry, and their points. */
    private final int[] rayOf = new int[RayBatch.MAX_RAYS];
    private final int[] pointOf = new int[RayBatch.MAX_RAYS];
    private int count;
    /** Points of the rays to cast in the geometry before the edit. */
    private final int[] knownPointOf = new int[RayBatch.MAX_RAYS];
    private int knownCount;
    private long rays;
    /** Rays of one point that may hit something else than before the edit. */
    private final BitSet changed = new BitSet();

    /** @param beforeTracer tracer of the geometry before the edit */
    MemoCaster(PathMemo memo, Geometry geometry, Scene scene, Tracer tracer, Tracer beforeTracer, CellKeys keys,
            DirectionTable directions, GlowShapes glows) {
        this.glows = glows;
        this.memo = memo;
        this.keys = keys;
        this.directions = directions;
        now = new RayBatch(geometry, scene, tracer);
        before = new RayBatch(memo.geometry(), scene, beforeTracer);
        x = new double[directions.rays()];
        y = new double[directions.rays()];
        z = new double[directions.rays()];
    }

    /** Returns the number of rays cast so far. */
    long rayCount() {
        return rays;
    }

    /**
     * Repeats the rays of points {@code from … to − 1}.
     *
     * @param known          rays before the edit
     * @param links          receives the cell that each ray hit
     * @param inverseLengths receives the sum of the {@link InverseLengths} of each point's rays; null if not wanted
     */
    void cast(RaySources points, int from, int to, KnownRays known, RayLinks links, long @Nullable [] inverseLengths) {
        links.clear(from * directions.rays(), to * directions.rays());
        for (int p = from; p < to; p++) {
            points.writeDirections(p, directions, x, y, z, 0);
            int old = known.find(points, p);
            if (old >= 0) {
                findChanges(points, p);
                // To replace terms of the sum, rays are cast before and after the edit: no fewer than all once.
                old = inverseLengths != null && 2 * changed.cardinality() >= directions.rays() ? KnownRays.UNKNOWN : old;
            }
            if (inverseLengths != null) {
                inverseLengths[p] = old < 0 ? 0 : memo.inverseLengths(old);
            }
            for (int k = 0; k < directions.rays(); k++) {
                if (old >= 0 && !changed.get(k)) {
                    int surfel = known.surfel(old * directions.rays() + k);
                    if (surfel != RayLinks.MISS) {
                        links.setKey(p * directions.rays() + k, memo.key(surfel),
                                glows.isAimed(memo.places().primitive[surfel], points.surface, p));
                    } else {
                        links.setMiss(p * directions.rays() + k, x[k], y[k], z[k]);
                    }
                } else {
                    add(points, p, k, old >= 0 && inverseLengths != null);
                    if (count == RayBatch.MAX_RAYS) {
                        flush(points.surface, links, inverseLengths);
                    }
                }
            }
        }
        flush(points.surface, links, inverseLengths);
    }

    private void findChanges(RaySources points, int p) {
        changed.clear();
        for (int k = 0; k < directions.rays(); k++) {
            changed.set(k, mayChange(points, p, k));
        }
    }

    private boolean mayChange(RaySources points, int p, int k) {
        boxRay.setRay(points.start(p, 0), points.start(p, 1), points.start(p, 2), x[k], y[k], z[k]);
        return memo.mayChange(boxRay);
    }

    private void add(RaySources points, int p, int k, boolean known) {
        rayOf[count] = p * directions.rays() + k;
        pointOf[count] = p;
        set(now, count++, points, p, k);
        if (known) {
            knownPointOf[knownCount] = p;
            set(before, knownCount++, points, p, k);
        }
    }

    private void set(RayBatch batch, int ray, RaySources points, int p, int k) {
        points.setStart(p, batch, ray);
        batch.directionX[ray] = x[k];
        batch.directionY[ray] = y[k];
        batch.directionZ[ray] = z[k];
    }

    private void flush(SurfaceColumns points, RayLinks links, long @Nullable [] inverseLengths) {
        if (count > 0) {
            now.trace(count);
            rays += count;
            HitRows rows = now.rowsWithoutTexels();
            for (int row = 0; row < rows.count; row++) {
                int ray = rows.parent[row];
                links.setKey(rayOf[ray], keys.surfelKey(rows, row, now.primitive(ray), now.distance(ray)),
                        glows.isAimed(now.primitive(ray), points, pointOf[ray]));
            }
            for (int ray = 0; ray < count; ray++) {
                if (now.primitive(ray) < 0) {
                    links.setMiss(rayOf[ray], now.directionX[ray], now.directionY[ray], now.directionZ[ray]);
                }
            }
            for (int ray = 0; now.isTinted() && ray < count; ray++) {
                links.setTints(rayOf[ray], 1, now.tint, ray);
            }
            for (int ray = 0; inverseLengths != null && ray < count; ray++) {
                inverseLengths[pointOf[ray]] += term(now, ray, points, pointOf[ray]);
            }
        }
        if (knownCount > 0) {
            assert inverseLengths != null;
            before.trace(knownCount);
            rays += knownCount;
            for (int ray = 0; ray < knownCount; ray++) {
                inverseLengths[knownPointOf[ray]] -= term(before, ray, points, knownPointOf[ray]);
            }
        }
        count = 0;
        knownCount = 0;
    }

    private long term(RayBatch batch, int ray, SurfaceColumns points, int p) {
        return batch.primitive(ray) < 0 ? 0 : InverseLengths.term(batch.distance(ray), keys.side(points, p));
    }

    /**
     * Returns the surfel before the edit whose row is the hit of a ray; {@link RayLinks#MISS} for none.
     *
     * @param ofPoints whether it is a ray of a gather point
     */
    int knownSurfel(RaySources points, int ray, KnownRays known, boolean ofPoints) {
        int p = ray / directions.rays();
        int k = ray % directions.rays();
        int old = known.find(points, p);
        if (old < 0) {
            return RayLinks.MISS;
        }
        int oldRay = old * directions.rays() + k;
        int surfel = known.surfel(oldRay);
        if (surfel == RayLinks.MISS
                || !(ofPoints ? memo.isFirstOfPoints(surfel, oldRay) : memo.isFirstOfSurfels(surfel, oldRay))) {
            return RayLinks.MISS;
        }
        points.writeDirections(p, directions, x, y, z, 0);
        return mayChange(points, p, k) ? RayLinks.MISS : surfel;
    }
}
