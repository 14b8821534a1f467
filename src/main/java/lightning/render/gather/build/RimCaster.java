package lightning.render.gather.build;

import java.util.Arrays;
import java.util.BitSet;
import java.util.concurrent.atomic.LongAdder;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.KnownRays;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.gather.rim.RimAim;
import lightning.render.gather.rim.RimCells;
import lightning.render.gather.rim.RimLinks;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.BoxRay;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Casts the additional rays of gather points through cells of directions that contain the rim of an opening. They find no new surfels: one that
 * hits a cell without a surfel counts what the next of the point's own rays hits. After an edit, rays that a memo knows are not cast.
 */
final class RimCaster {
    private static final int BATCH = 256;

    private final CellKeys keys;
    private final DirectionTable directions;
    private final GlowShapes glows;
    private final RaySources points;
    private final RayLinks links;
    private final CellTable surfels;
    private final @Nullable PathMemo memo;
    private final LongAdder rays = new LongAdder();
    /** First cell and first ray of each point, and the numbers of all. */
    private int[] firstCell = {};
    private int[] firstRay = {};
    private char[] cell = {};
    /** Number of each ray, as in {@link RayLinks}, and its tint; null if none is tinted. */
    private int[] number = {};
    private float @Nullable [][] tint;

    /**
     * @param points  gather points
     * @param links   finished links of these
     * @param surfels numbers of the surfels by cell
     * @param memo    paths before an edit
     */
    RimCaster(CellKeys keys, DirectionTable directions, GlowShapes glows, RaySources points, RayLinks links, CellTable surfels,
            @Nullable PathMemo memo) {
        this.memo = memo;
        this.keys = keys;
        this.directions = directions;
        this.glows = glows;
        this.points = points;
        this.links = links;
        this.surfels = surfels;
    }

    /**
     * Casts the rays.
     *
     * @param tracers one for each thread
     * @throws lightning.render.gather.ray.PathsTooLargeException if the paths need more memory than there is
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    RimLinks cast(RimCells rims, Geometry geometry, Scene scene, Tracer[] tracers, WorkerPool workers, PathMemory memory,
            Progress progress) {
        firstCell = new int[links.points() + 1];
        firstRay = new int[links.points() + 1];
        char[][] cells = new char[links.points()][];
        workers.run(jobs(), (_, job) -> {
            char[] found = new char[links.raysPerPoint()];
            for (int p = job * BATCH; p < end(job); p++) {
                int count = rims.find(p, found);
                cells[p] = Arrays.copyOf(found, RimAim.raysPerCell(count, links.raysPerPoint()) > 1 ? count : 0);
            }
        }, progress.cancellationOnly());
        for (int p = 0; p < cells.length; p++) {
            int added = cells[p].length * (RimAim.raysPerCell(cells[p].length, links.raysPerPoint()) - 1);
            memory.reserve(added, RimLinks.BUILD_BYTES);
            firstCell[p + 1] = firstCell[p] + cells[p].length;
            firstRay[p + 1] = firstRay[p] + added;
        }
        cell = new char[firstCell[cells.length]];
        number = new int[firstRay[cells.length]];
        for (int p = 0; p < cells.length; p++) {
            System.arraycopy(cells[p], 0, cell, firstCell[p], cells[p].length);
        }
        Batch[] batches = new Batch[tracers.length];
        Arrays.setAll(batches, worker -> new Batch(new RayBatch(geometry, scene, tracers[worker])));
        workers.run(jobs(), (worker, job) -> batches[worker].cast(job * BATCH, end(job)), progress);
        BitSet substituted = new BitSet();
        for (Batch batch : batches) {
            substituted.or(batch.substituted);
        }
        return new RimLinks(firstCell, firstRay, cell, links.withRays(number, tint), substituted.stream().toArray());
    }

    private int jobs() {
        return Math.ceilDiv(links.points(), BATCH);
    }

    private int end(int job) {
        return Math.min(links.points(), job * BATCH + BATCH);
    }

    /** Returns the number of rays cast so far. */
    long rayCount() {
        return rays.sum();
    }

    private synchronized float[][] allocateTints() {
        if (tint == null) {
            float[][] all = new float[3][number.length];
            for (float[] channel : all) {
                Arrays.fill(channel, 1);
            }
            tint = all;
        }
        return tint;
    }

    /** Rays of one thread. */
    private final class Batch {
        private final RayBatch batch;
        /** Each ray to cast, its point and its cell. */
        private final int[] rayOf = new int[RayBatch.MAX_RAYS];
        private final int[] pointOf = new int[RayBatch.MAX_RAYS];
        private final char[] cellOf = new char[RayBatch.MAX_RAYS];
        private final BoxRay boxRay = new BoxRay();
        /** Directions around one point with a turn. */
        private final double[] x = new double[directions.rays()];
        private final double[] y = new double[directions.rays()];
        private final double[] z = new double[directions.rays()];
        private final BitSet substituted = new BitSet();
        private int count;

        Batch(RayBatch batch) {
            this.batch = batch;
        }

        void cast(int from, int to) {
            for (int p = from; p < to; p++) {
                int cells = firstCell[p + 1] - firstCell[p];
                int added = cells == 0 ? 0 : (firstRay[p + 1] - firstRay[p]) / cells;
                int old = memo == null || added == 0 ? KnownRays.UNKNOWN : memo.points().find(points, p);
                for (int nth = 1; nth <= added; nth++) {
                    points.writeDirections(p, directions, RimAim.turn(nth), x, y, z, 0);
                    for (int i = 0; i < cells; i++) {
                        char k = cell[firstCell[p] + i];
                        int ray = firstRay[p] + i * added + nth - 1;
                        if (old < 0 || !repeat(ray, p, k, old, nth)) {
                            add(ray, p, k);
                        }
                    }
                }
            }
            flush();
        }

        /** Takes what a ray hit before an edit; returns whether it is known. */
        private boolean repeat(int ray, int p, char k, int old, int nth) {
            assert memo != null;
            int known = memo.rims().find(old, k, nth);
            boxRay.setRay(points.start(p, 0), points.start(p, 1), points.start(p, 2), x[k], y[k], z[k]);
            if (known < 0 || memo.mayChange(boxRay)) {
                return false;
            }
            int surfel = memo.rims().surfel(known);
            if (surfel == RayLinks.MISS) {
                number[ray] = links.missNumber(x[k], y[k], z[k]);
            } else {
                setHit(ray, memo.key(surfel), memo.places().primitive[surfel], p, k);
            }
            return true;
        }

        private void add(int ray, int p, char k) {
            if (count == RayBatch.MAX_RAYS) {
                flush();
            }
            rayOf[count] = ray;
            pointOf[count] = p;
            cellOf[count] = k;
            points.setStart(p, batch, count);
            batch.directionX[count] = x[k];
            batch.directionY[count] = y[k];
            batch.directionZ[count++] = z[k];
        }

        private void flush() {
            if (count == 0) {
                return;
            }
            batch.trace(count);
            rays.add(count);
            HitRows rows = batch.rowsWithoutTexels();
            for (int row = 0; row < rows.count; row++) {
                int i = rows.parent[row];
                setHit(rayOf[i], keys.surfelKey(rows, row, batch.primitive(i), batch.distance(i)), batch.primitive(i), pointOf[i],
                        cellOf[i]);
            }
            float[][] tints = batch.isTinted() ? allocateTints() : null;
            for (int i = 0; i < count; i++) {
                if (batch.primitive(i) < 0) {
                    number[rayOf[i]] = links.missNumber(batch.directionX[i], batch.directionY[i], batch.directionZ[i]);
                }
                for (int c = 0; tints != null && c < 3; c++) {
                    tints[c][rayOf[i]] = batch.tint[c][i];
                }
            }
            count = 0;
        }

        /** @param key of the cell that a ray hits */
        private void setHit(int ray, long key, int primitive, int p, char k) {
            int surfel = surfels.number(key);
            if (surfel < 0) {
                substituted.set(ray);
                number[ray] = nextHit(p, k);
            } else {
                number[ray] = links.number(surfel, glows.isAimed(primitive, points.surface, p));
            }
        }

        /** Returns the number of the first of a point's own rays, from ray {@code k} on, that hits a surface; that of ray {@code k} if none does. */
        private int nextHit(int p, int k) {
            int from = p * links.raysPerPoint();
            int next = k;
            for (int i = 0; i < links.raysPerPoint() && links.surfel(from + next) == RayLinks.MISS; i++) {
                next = (next + 1) % links.raysPerPoint();
            }
            return links.number(from + next);
        }
    }
}
