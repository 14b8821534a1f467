package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.CellPlacer;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.SeenSurfaces;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.point.PointFilter;
import lightning.render.gather.ray.InverseLengths;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.SurfelRays;
import lightning.render.lobe.RoughLobes;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Chooses the points whose reflections are computed among surfaces that are seen: one in each cell of position and mirrored view. The narrower the lobe and the nearer what it reflects, the smaller are the cells.
 */
public final class ReflectionPlacer extends CellPlacer {
    private static final int LEVELS = 4;
    /** Width α at which a lobe counts as narrow. */
    private static final double NARROW = 0.4;

    /** Share of the width of a lobe where it meets something, within which a reflection changes little. */
    private static final double OPEN = 0.25;

    private final WorkerPool workers;
    private final ProgressPart progress;
    private final CellKeys keys;
    private final ReflectionCaster[] casters;
    private final @Nullable RoughLobes[] lobes;
    private final int[] materialOf;
    private SeenSurfaces candidates = new SeenSurfaces(0);
    private final int lobeRays;
    private final RepeatedPoints repeated;
    private long raysCast;
    public final ReflectionPoints points;
    public final ReflectionLinks links;
    private final float[] steps;
    private ReflectionGroup[] groups = {};
    private @Nullable PointFilter filter;
    /** Number of points without their copies. */
    private int placed;
    private int[] firstCopy = {};
    private long[] inverseLengths = {};
    /** Distance from each point within which its reflection changes little, scene units. */
    private float[] open = {};

    /**
     * @param casters    one for each thread
     * @param lobes      by material
     * @param materialOf material of each primitive
     * @param lobeRays   how many of the rays are those of lobes
     * @param memo       paths before an edit
     */
    public ReflectionPlacer(WorkerPool workers, ProgressPart progress, CellKeys keys, ReflectionCaster[] casters,
            @Nullable RoughLobes[] lobes, int[] materialOf, int raysPerPoint, int lobeRays, PathMemory memory,
            @Nullable ReflectionMemo memo) {
        this.workers = workers;
        this.progress = progress;
        this.keys = keys;
        this.casters = casters;
        this.lobes = lobes;
        this.materialOf = materialOf;
        points = new ReflectionPoints(keys);
        steps = steps(lobes);
        this.lobeRays = lobeRays;
        repeated = new RepeatedPoints(memo, raysPerPoint);
        links = new ReflectionLinks(raysPerPoint, memory);
    }

    /** Returns the widths of the cells of directions by material; 0 for materials that do not blur reflections. */
    private static float[] steps(@Nullable RoughLobes[] lobes) {
        float[] steps = new float[lobes.length];
        for (int m = 0; m < steps.length; m++) {
            RoughLobes its = lobes[m];
            steps[m] = its == null ? 0 : (float) step(its.narrowest());
        }
        return steps;
    }

    /** Returns the width of the cells of directions for a lobe of width α, about radians. */
    private static double step(double alpha) {
        return Math.clamp(alpha, 0.02, 0.4);
    }

    /**
     * Chooses the points and casts their rays.
     *
     * @param levels    surfaces that the picture shows, in order
     * @param materials all materials
     */
    public void place(List<SeenSurfaces> levels, List<Material> materials) {
        candidates = rough(levels);
        place(candidates.count(), LEVELS, workers, progress.cancellationOnly());
        groups = ReflectionGroup.of(points, steps, materials);
        placed = points.count();
        ReflectionFilter weights = ReflectionFilter.of(groups, placed, open, workers, progress);
        int[] copies = weights.copies(shares());
        addCopies(copies);
        filter = weights.build(copies);
    }

    /**
     * Returns the paths of the points after {@link #place}, as {@link ReflectionPaths}. Call this once, after all surfels are found.
     *
     * @param surfelFilter of the surfels that gather light
     * @param firstRay     as in {@link ReflectionOrigins}, with {@code partKeys}
     */
    public ReflectionPaths paths(GlowShapes glows, int[] surfelOfDetail, PointFilter surfelFilter, int[] firstRay, long[] partKeys) {
        ReflectionOrigins origins = new ReflectionOrigins(Arrays.copyOf(points.seed, placed), Arrays.copyOf(inverseLengths, placed),
                firstCopy, firstRay, partKeys);
        points.trim(placed);
        return new ReflectionPaths(points, links, groups, requireNonNull(filter), steps, glows, surfelOfDetail, surfelFilter, origins);
    }

    /** Replaces keys by numbers, as {@link ReflectionLinks#finish}. */
    public void finish(CellTable cells, CellTable details, int surfels, Progress part) {
        links.finish(cells, details, surfels, repeated, workers, part);
    }

    /** Returns the rays of the points as they find surfels, or parts of surfels. */
    public SurfelRays rays(boolean details) {
        return new ReflectionRays(points, links, casters, details, repeated);
    }

    /** Returns the surfaces that blur their reflections. */
    private SeenSurfaces rough(List<SeenSurfaces> levels) {
        SeenSurfaces all = new SeenSurfaces(1024);
        for (SeenSurfaces level : levels) {
            for (int i = 0; i < level.count(); i++) {
                if (lobes[materialOf[level.surfaces.primitive[i]]] != null) {
                    all.add(level, i);
                }
            }
        }
        return all;
    }

    private long key(SeenSurfaces c, int i, int primitive, int level) {
        SurfaceColumns s = c.surfaces;
        float[] mirrored = new float[3];
        ReflectionPoints.mirror(s.nx[i], s.ny[i], s.nz[i], c.vx[i], c.vy[i], c.vz[i], mirrored);
        double step = step(requireNonNull(lobes[materialOf[s.primitive[i]]]).narrowest());
        return keys.reflectionKey(s.px[i], s.py[i], s.pz[i], mirrored[0], mirrored[1], mirrored[2], step, primitive, level);
    }

    @Override
    protected long cell(int candidate, int level) {
        return key(candidates, candidate, candidates.surfaces.primitive[candidate], level);
    }

    @Override
    protected int count() {
        return points.count();
    }

    @Override
    protected int add(int candidate, int level) {
        points.add(candidates, candidate, materialOf[candidates.surfaces.primitive[candidate]], key(candidates, candidate, NONE, level));
        repeated.addPoint(points);
        return points.count() - 1;
    }

    @Override
    protected void added(int first, int level) {
        cast(first, progress.section(level, LEVELS + 1));
    }

    /**
     * Adds points with other rays at the places of those there are, after all of them.
     *
     * @param copies number for each point
     */
    private void addCopies(int[] copies) {
        int first = points.count();
        firstCopy = new int[first];
        for (int p = 0; p < first; p++) {
            firstCopy[p] = points.count();
            for (int k = 1; k <= copies[p]; k++) {
                points.addCopy(p, ReflectionDirections.seed(points.seed[p], k));
                repeated.addCopy(p, k);
            }
        }
        cast(first, progress.section(LEVELS, LEVELS + 1));
    }

    private float[] shares() {
        float[] shares = new float[placed];
        for (int p = 0; p < placed; p++) {
            shares[p] = share(p);
        }
        return shares;
    }

    /** Returns about the share of light that the surface of a point reflects, 0…1. */
    private float share(int p) {
        SurfaceColumns s = points.surface();
        float cosine = -(points.seen.vx[p] * s.nx[p] + points.seen.vy[p] * s.ny[p] + points.seen.vz[p] * s.nz[p]);
        return (float) requireNonNull(lobes[points.material[p]]).share(Math.clamp(cosine, 0, 1), points.seen.roughness[p]);
    }

    /** Casts the rays of the points from {@code first} on. */
    private void cast(int first, Progress part) {
        int count = points.count();
        inverseLengths = Arrays.copyOf(inverseLengths, count);
        links.setPoints(count);
        points.sources.reserveNormals(count);
        workers.run(Math.ceilDiv(count - first, BATCH), (worker, job) -> {
            int from = first + job * BATCH;
            int to = Math.min(count, from + BATCH);
            casters[worker].findNormals(points, from, to);
            repeated.forgetChanged(points, from, to, casters[worker]);
            for (int p = from; p < to; p++) {
                if (repeated.isKnown(p)) {
                    repeated.write(p, links);
                    inverseLengths[p] = firstCopy.length == 0 ? repeated.inverseLengths(p) : 0;
                }
            }
        }, progress.cancellationOnly());
        int[] selected = IntStream.range(first, count).filter(p -> !repeated.isKnown(p)).toArray();
        raysCast += (long) selected.length * links.raysPerPoint();
        int batch = casters[0].pointsPerBatch();
        workers.run(Math.ceilDiv(selected.length, batch), (worker, job) -> {
            int from = job * batch;
            casters[worker].cast(points, selected, from, Math.min(selected.length, from + batch), links, inverseLengths);
        }, part);
    }

    @Override
    protected boolean divide(int p, int level) {
        SurfaceColumns s = points.surface();
        points.radius[p] = RADIUS * (float) keys.side(s.px[p], s.py[p], s.pz[p], level);
        double spread = Math.min(1, requireNonNull(lobes[points.material[p]]).narrowest() / NARROW);
        float harmonic = InverseLengths.harmonicMean(inverseLengths[p], lobeRays, keys.side(s, p));
        open = p < open.length ? open : Arrays.copyOf(open, 2 * points.count());
        open[p] = (float) (OPEN * spread * harmonic);
        return ACCURACY * spread * harmonic < share(p) * points.radius[p] && level + 1 < LEVELS;
    }

    /** Returns the number of rays cast. */
    public long rayCount() {
        return raysCast;
    }
}
