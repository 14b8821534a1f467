package lightning.render.gather;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Casts the additional rays of gather points through cells of directions that contain the rim of an opening. They find no new surfels: one that
 * hits a cell without a surfel counts what the next of the point's own rays hits.
 */
final class RimCaster {
    private static final int BATCH = 256;

    private final CellKeys keys;
    private final DirectionTable directions;
    private final GlowShapes glows;
    private final RaySources points;
    private final RayLinks links;
    private final CellTable surfels;
    /** First cell and first ray of each point, and the numbers of all. */
    private final int[] firstCell;
    private final int[] firstRay;
    private char[] cell = {};
    /** Number of each ray, as in {@link RayLinks}, and its tint; null if none is tinted. */
    private int[] number = {};
    private float @Nullable [][] tint;

    /**
     * @param points  gather points
     * @param links   finished links of these
     * @param surfels numbers of the surfels by cell
     */
    RimCaster(CellKeys keys, DirectionTable directions, GlowShapes glows, RaySources points, RayLinks links, CellTable surfels) {
        this.keys = keys;
        this.directions = directions;
        this.glows = glows;
        this.points = points;
        this.links = links;
        this.surfels = surfels;
        firstCell = new int[links.points() + 1];
        firstRay = new int[links.points() + 1];
    }

    /**
     * Casts the rays.
     *
     * @param tracers one for each thread
     * @throws PathsTooLargeException if the paths need more memory than there is
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    RimLinks cast(RimCells rims, Geometry geometry, Scene scene, Tracer[] tracers, WorkerPool workers, PathMemory memory,
            Progress progress) {
        char[][] cells = new char[links.points()][];
        workers.run(jobs(), (_, job) -> {
            char[] found = new char[links.raysPerPoint()];
            for (int p = job * BATCH; p < end(job); p++) {
                int count = rims.find(p, found);
                cells[p] = Arrays.copyOf(found, RimAim.raysPerCell(count, links.raysPerPoint()) > 1 ? count : 0);
            }
        }, progress);
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
        return new RimLinks(firstCell, firstRay, cell, links.withRays(number, tint));
    }

    private int jobs() {
        return Math.ceilDiv(links.points(), BATCH);
    }

    private int end(int job) {
        return Math.min(links.points(), job * BATCH + BATCH);
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
        /** Point and cell of each ray. */
        private final int[] pointOf = new int[RayBatch.MAX_RAYS];
        private final int[] cellOf = new int[RayBatch.MAX_RAYS];
        /** Directions around one point with a turn. */
        private final double[] x = new double[directions.rays()];
        private final double[] y = new double[directions.rays()];
        private final double[] z = new double[directions.rays()];
        private int count;

        Batch(RayBatch batch) {
            this.batch = batch;
        }

        void cast(int from, int to) {
            int done = firstRay[from];
            for (int p = from; p < to; p++) {
                int cells = firstCell[p + 1] - firstCell[p];
                int added = cells == 0 ? 0 : (firstRay[p + 1] - firstRay[p]) / cells;
                if (count + cells * added > RayBatch.MAX_RAYS) {
                    flush(done);
                    done = firstRay[p];
                }
                for (int e = 1; e <= added; e++) {
                    points.writeDirections(p, directions, RimAim.turn(e), x, y, z, 0);
                    for (int i = 0; i < cells; i++) {
                        set(count + i * added + e - 1, p, cell[firstCell[p] + i]);
                    }
                }
                count += cells * added;
            }
            flush(done);
        }

        private void set(int ray, int p, int k) {
            pointOf[ray] = p;
            cellOf[ray] = k;
            batch.startX[ray] = points.surface.px[p];
            batch.startY[ray] = points.surface.py[p];
            batch.startZ[ray] = points.surface.pz[p];
            batch.directionX[ray] = x[k];
            batch.directionY[ray] = y[k];
            batch.directionZ[ray] = z[k];
        }

        /** @param first first ray of the batch among all */
        private void flush(int first) {
            if (count == 0) {
                return;
            }
            batch.trace(count);
            HitRows rows = batch.rowsWithoutTexels();
            for (int row = 0; row < rows.count; row++) {
                int ray = rows.parent[row];
                int primitive = batch.primitive(ray);
                int surfel = surfels.number(keys.surfelKey(rows, row, primitive, batch.distance(ray)));
                number[first + ray] = surfel < 0 ? nextHit(pointOf[ray], cellOf[ray])
                        : links.number(surfel, glows.isAimed(primitive, points.surface, pointOf[ray]));
            }
            for (int ray = 0; ray < count; ray++) {
                if (batch.primitive(ray) < 0) {
                    number[first + ray] = links.missNumber(batch.directionX[ray], batch.directionY[ray], batch.directionZ[ray]);
                }
            }
            if (batch.isTinted()) {
                float[][] all = allocateTints();
                for (int c = 0; c < 3; c++) {
                    System.arraycopy(batch.tint[c], 0, all[c], first, count);
                }
            }
            count = 0;
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
