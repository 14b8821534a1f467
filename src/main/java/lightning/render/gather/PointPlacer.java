package lightning.render.gather;

import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;

/**
 * Chooses gather points among candidates: one in each cell. Where other surfaces are near, seen from the point, the cell is divided, as an
 * irradiance cache does (G. Ward and others, A ray tracing solution for diffuse interreflection, 1988).
 */
final class PointPlacer {
    private static final int BATCH = 4096;
    /** Radius of a point in sides of its cell. */
    private static final float RADIUS = 1.5f;
    /** Largest radius relative to the harmonic mean distance of the surfaces around. */
    private static final float ACCURACY = 0.25f;

    private final WorkerPool workers;
    private final Progress progress;
    private final CellKeys keys;
    private final GatherCaster[] casters;
    private final int pointsPerBatch;
    final SurfaceColumns points = new SurfaceColumns();
    final RayLinks links;
    private long[] seeds = {};
    float[] harmonic = {};
    float[] radius = {};
    /** Side of the largest cell at each point. */
    float[] side = {};

    PointPlacer(WorkerPool workers, Progress progress, CellKeys keys, GatherCaster[] casters, DirectionTable directions) {
        this.workers = workers;
        this.progress = progress;
        this.keys = keys;
        this.casters = casters;
        pointsPerBatch = GatherCaster.pointsPerBatch(directions);
        links = new RayLinks(directions.rays());
    }

    /** @param levels surfaces that the picture shows, in order */
    void place(List<SurfaceColumns> levels) {
        SurfaceColumns candidates = join(levels);
        int[] active = new int[candidates.count];
        Arrays.setAll(active, i -> i);
        long[] cell = new long[candidates.count];
        for (int level = 0; level < CellKeys.LEVELS && active.length > 0; level++) {
            CellTable cells = CellTable.ofLowest();
            int[] chosen = choose(candidates, active, cell, level, cells);
            boolean[] divided = addPoints(candidates, chosen, cell, level);
            for (int i = 0; i < chosen.length; i++) {
                cells.setNumber(cell[chosen[i]], divided[i] ? 1 : 0);
            }
            int kept = 0;
            for (int candidate : active) {
                if (cells.number(cell[candidate]) == 1) {
                    active[kept++] = candidate;
                }
            }
            active = Arrays.copyOf(active, kept);
        }
    }

    private static SurfaceColumns join(List<SurfaceColumns> levels) {
        SurfaceColumns all = new SurfaceColumns();
        all.reserve(levels.stream().mapToInt(SurfaceColumns::count).sum());
        for (SurfaceColumns level : levels) {
            for (int i = 0; i < level.count; i++) {
                all.add(level, i);
            }
        }
        return all;
    }

    /** Returns the first candidate in each cell of a level; writes the cells of the candidates. */
    private int[] choose(SurfaceColumns c, int[] active, long[] cell, int level, CellTable cells) {
        workers.run(Math.ceilDiv(active.length, BATCH), (_, job) -> {
            for (int i = job * BATCH; i < Math.min(active.length, job * BATCH + BATCH); i++) {
                int k = active[i];
                cell[k] = keys.pointKey(c.px[k], c.py[k], c.pz[k], c.nx[k], c.ny[k], c.nz[k], c.primitive[k], level);
                cells.add(cell[k], k);
            }
        }, progress.cancellationOnly());
        return cells.firsts();
    }

    /** Adds points at some candidates; returns which of their cells must be divided. */
    private boolean[] addPoints(SurfaceColumns candidates, int[] chosen, long[] cell, int level) {
        int first = points.count;
        int count = first + chosen.length;
        points.reserve(count);
        for (int candidate : chosen) {
            points.add(candidates, candidate);
        }
        seeds = Arrays.copyOf(seeds, count);
        harmonic = Arrays.copyOf(harmonic, count);
        radius = Arrays.copyOf(radius, count);
        side = Arrays.copyOf(side, count);
        for (int i = 0; i < chosen.length; i++) {
            seeds[first + i] = cell[chosen[i]];
        }
        links.setPoints(count);
        workers.run(Math.ceilDiv(chosen.length, pointsPerBatch), (worker, job) -> {
            int from = first + job * pointsPerBatch;
            casters[worker].cast(points, seeds, from, Math.min(count, from + pointsPerBatch), links, harmonic);
        }, progress.cancellationOnly());
        boolean[] divided = new boolean[chosen.length];
        for (int p = first; p < count; p++) {
            float cellSide = (float) keys.side(points.px[p], points.py[p], points.pz[p], level);
            boolean isNear = ACCURACY * harmonic[p] < RADIUS * cellSide;
            divided[p - first] = isNear && level + 1 < CellKeys.LEVELS;
            radius[p] = RADIUS * (divided[p - first] ? cellSide / 2 : cellSide);
            side[p] = (float) keys.side(points.px[p], points.py[p], points.pz[p], 0);
        }
        return divided;
    }

    /** Returns the seed of each point's directions. */
    long[] seeds() {
        return seeds;
    }
}
