package lightning.render.gather.build;

import java.util.Arrays;
import java.util.List;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.CellPlacer;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;

/** Chooses gather points among surfaces that the picture shows. */
final class PointPlacer extends CellPlacer {
    private final WorkerPool workers;
    private final ProgressPart progress;
    private final CellKeys keys;
    private final PathCaster caster;
    private SurfaceColumns candidates = new SurfaceColumns();
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
        candidates = join(levels);
        place(candidates.count, CellKeys.LEVELS, workers, progress.cancellationOnly());
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

    @Override
    protected long cell(int i, int level) {
        SurfaceColumns c = candidates;
        return keys.pointKey(c.px[i], c.py[i], c.pz[i], c.nx[i], c.ny[i], c.nz[i], c.primitive[i], level);
    }

    @Override
    protected int count() {
        return points.count;
    }

    @Override
    protected int add(int candidate, int level) {
        points.add(candidates, candidate);
        return points.count - 1;
    }

    @Override
    protected void added(int first, int level) {
        sources.levelStart[level] = first;
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

    @Override
    protected boolean divide(int p, int level) {
        float cellSide = (float) keys.side(points.px[p], points.py[p], points.pz[p], level);
        radius[p] = RADIUS * cellSide;
        side[p] = (float) keys.side(points, p);
        return ACCURACY * harmonic[p] < radius[p] && level + 1 < CellKeys.LEVELS;
    }
}
