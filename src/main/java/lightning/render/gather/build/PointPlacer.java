package lightning.render.gather.build;

import java.util.Arrays;
import java.util.List;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;

/**
 * Chooses gather points among candidates: one in each cell that is not divided. Where other surfaces are near, seen from the point, the
 * cell is divided, as an
 * irradiance cache does (G. Ward and others, A ray tracing solution for diffuse interreflection, 1988).
 */
final class PointPlacer {
    private static final int BATCH = 4096;
    private static final int NONE = -1;
    /** Radius of a point in sides of its cell. */
    private static final float RADIUS = 1.2f;
    /** Largest radius relative to the harmonic mean distance of the surfaces around. */
    private static final float ACCURACY = 0.2f;

    private final WorkerPool workers;
    private final ProgressPart progress;
    private final CellKeys keys;
    private final PathCaster caster;
    final SurfaceColumns points = new SurfaceColumns();
    final RaySources sources;
    final RayLinks links;
    long[] inverseLengths = {};
    float[] harmonic = {};
    float[] radius = {};
    /** Side of the largest cell at each point. */
    float[] side = {};

    PointPlacer(WorkerPool workers, ProgressPart progress, CellKeys keys, PathCaster caster, PathMemory memory) {
        this.workers = workers;
        this.progress = progress;
        this.keys = keys;
        this.caster = caster;
        sources = new RaySources(keys, points, false);
        links = new RayLinks(caster.raysPerPoint, keys.misses(), memory);
    }

    /** @param levels surfaces that the picture shows, in order */
    void place(List<SurfaceColumns> levels) {
        SurfaceColumns candidates = join(levels);
        int[] active = new int[candidates.count];
        Arrays.setAll(active, i -> i);
        long[] cell = new long[candidates.count];
        int[] point = new int[candidates.count];
        Arrays.fill(point, NONE);
        for (int level = 0; level < CellKeys.LEVELS && active.length > 0; level++) {
            CellTable cells = new CellTable();
            int[] chosen = choose(candidates, active, cell, level, cells);
            sources.levelStart[level] = points.count;
            addPoints(candidates, chosen, point, level);
            for (int candidate : chosen) {
                cells.setNumber(cell[candidate], divide(point[candidate], level) ? 1 : 0);
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

    /**
     * Adds points at the chosen candidates that are none yet: the first candidate of a cell is also the first of one of its parts.
     *
     * @param point of each candidate, or {@link #NONE}
     */
    private void addPoints(SurfaceColumns candidates, int[] chosen, int[] point, int level) {
        int first = points.count;
        points.reserve(first + chosen.length);
        for (int candidate : chosen) {
            if (point[candidate] == NONE) {
                point[candidate] = points.count;
                points.add(candidates, candidate);
            }
        }
        int count = points.count;
        inverseLengths = Arrays.copyOf(inverseLengths, count);
        harmonic = Arrays.copyOf(harmonic, count);
        radius = Arrays.copyOf(radius, count);
        side = Arrays.copyOf(side, count);
        links.setPoints(count);
        caster.cast(sources, first, count, links, inverseLengths, progress.section(level, CellKeys.LEVELS));
        for (int p = first; p < count; p++) {
            harmonic[p] = InverseLengths.harmonicMean(inverseLengths[p], links.raysPerPoint(), keys.side(points, p));
        }
    }

    /** Sets the radius of a cell's point; returns whether the cell must be divided. Its point then belongs to one of the parts. */
    private boolean divide(int p, int level) {
        float cellSide = (float) keys.side(points.px[p], points.py[p], points.pz[p], level);
        radius[p] = RADIUS * cellSide;
        side[p] = (float) keys.side(points, p);
        return ACCURACY * harmonic[p] < radius[p] && level + 1 < CellKeys.LEVELS;
    }
}
