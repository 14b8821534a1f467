package lightning.render.gather.build;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.gather.ray.SurfelRays;
import lightning.render.gather.ray.TiltedFacets;
import lightning.render.gather.reflection.ReflectionLinks;
import lightning.render.gather.reflection.ReflectionPlacer;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import org.jspecify.annotations.Nullable;

/**
 * Divides what rays hit into surfels, and links surfels by rays of their own for further bounces. Surfels that only a later bounce meets
 * are numbered after those before. After an edit, rows of surfels whose first ray is known are not built again.
 */
final class SurfelBuilder {
    /** A multiple of {@link lightning.render.gather.ray.RayNumbers#ALIGNMENT}. */
    private static final int BATCH = 1 << 14;

    private final WorkerPool workers;
    private final ProgressPart progress;
    private final CellKeys cellKeys;
    private final PathCaster caster;
    private final @Nullable KnownSurfels memo;
    private final CellTable cells = new CellTable();
    /** Parts of cells that narrow lobes meet. */
    private final CellTable details = new CellTable();
    /** For each part the surfel that it belongs to. */
    int[] surfelOfDetail = {};
    long[] partKeys = {};
    /** For each surfel the ray of a reflection whose hit it is; −1 for none. */
    int[] firstRay = {};
    private final SurfaceColumns surfels = new SurfaceColumns();
    private final RaySources sources;
    /** Surfels whose cells are small. */
    final BitSet near = new BitSet();
    HitRows[] blocks = {};
    /** Surfel of each row's parent in each block. */
    int[][] numbers = {};
    /** For each surfel of the memo its number now, −1 for none; null without a memo. */
    final int @Nullable [] kept;
    final RayLinks links;
    private final GlowShapes glows;
    /** Surfels on glowing objects, ascending. */
    int[] glowing = {};
    /** Rays of surfels by bounce. */
    final List<Long> bounceRays = new ArrayList<>();
    private final PathMemory memory;
    private final long bytesPerSurfel;

    /**
     * @param caster of the surfels' rays
     * @param memo   surfels before an edit
     * @param memory for surfels and their rays
     * @param bytesPerSurfel bytes of a surfel without its rays
     */
    SurfelBuilder(WorkerPool workers, ProgressPart progress, CellKeys cellKeys, PathCaster caster, @Nullable KnownSurfels memo,
            PathMemory memory, long bytesPerSurfel, GlowShapes glows) {
        this.glows = glows;
        this.memory = memory;
        this.bytesPerSurfel = bytesPerSurfel;
        this.workers = workers;
        this.progress = progress;
        this.cellKeys = cellKeys;
        this.caster = caster;
        this.memo = memo;
        sources = new RaySources(cellKeys, surfels, true);
        kept = memo == null ? null : new int[memo.places().count];
        if (memo != null) {
            Arrays.fill(kept, -1);
        }
        links = new RayLinks(caster.raysPerPoint, cellKeys.misses(), memory);
        links.setPoints(0);
    }

    int count() {
        return surfels.count;
    }

    /** Returns the numbers of the surfels by cell. */
    CellTable cells() {
        return cells;
    }

    /** Returns the places of the surfels, by number. */
    SurfaceColumns surfels() {
        return surfels;
    }

    /** Returns the normals of the surfaces of those surfels that cast rays and are shaded by another normal. */
    TiltedFacets packNormals() {
        return sources.packNormals();
    }

    /**
     * Builds all surfels.
     *
     * @param pointCaster of the gather points' rays
     */
    void build(RaySources points, RayLinks pointLinks, PathCaster pointCaster, @Nullable ReflectionPlacer reflecting,
            int bounces) {
        addSurfels(new PathRays(points, pointLinks, pointCaster), 0, cells);
        if (reflecting != null) {
            addReflected(reflecting.rays(false), cells);
        }
        int linked = 0;
        // The environment's light reaches the last surfels by rays of their own.
        int rounds = bounces == 0 || cellKeys.misses() == 1 ? bounces : bounces + 1;
        for (int bounce = 2; bounce <= rounds && linked < surfels.count; bounce++) {
            int from = linked;
            int to = surfels.count;
            links.setPoints(to);
            long raysBefore = caster.rayCount();
            caster.cast(sources, from, to, links, null, progress.section(bounce - 2, rounds - 1));
            bounceRays.add(caster.rayCount() - raysBefore);
            addSurfels(new PathRays(sources, links, caster), from * links.raysPerPoint(), cells);
            linked = to;
        }
        if (reflecting != null) {
            addDetails(reflecting);
        }
        glowing = IntStream.range(0, surfels.count).filter(s -> glows.contains(surfels.primitive[s])).toArray();
        number(pointLinks);
        number(links);
    }

    /** Adds the parts of surfels that reflections meet, after all surfels. */
    private void addDetails(ReflectionPlacer reflecting) {
        int whole = surfels.count;
        ReflectionLinks rays = reflecting.links;
        int[] firsts = addReflected(reflecting.rays(true), details);
        surfelOfDetail = Arrays.stream(firsts).map(ray -> cells.number(rays.key(ray))).toArray();
        partKeys = Arrays.stream(firsts).mapToLong(rays::detailKey).toArray();
        near.clear(whole, surfels.count);
        reflecting.finish(cells, details, surfels.count, progress.cancellationOnly());
    }

    /** Adds the surfels that rays of reflections find, as {@link #addSurfels}, and remembers these rays. */
    private int[] addReflected(SurfelRays rays, CellTable to) {
        int before = surfels.count;
        int[] firsts = addSurfels(rays, 0, to);
        int known = firstRay.length;
        firstRay = Arrays.copyOf(firstRay, surfels.count);
        Arrays.fill(firstRay, known, before, -1);
        System.arraycopy(firsts, 0, firstRay, before, firsts.length);
        return firsts;
    }

    /**
     * Adds a surfel for each new cell that some rays hit, in the order of the rays that come first.
     *
     * @param to receives the cells
     * @return the first ray of each new cell
     */
    private int[] addSurfels(SurfelRays rays, int firstRay, CellTable to) {
        int[] firsts = newCells(rays, firstRay, to);
        int before = surfels.count;
        surfels.reserve(before + firsts.length);
        for (int i = 0; i < firsts.length; i++) {
            long key = rays.key(firsts[i]);
            to.add(key, firsts[i]);
            to.setNumber(key, before + i);
        }
        int[] known = new int[firsts.length];
        workers.run(Math.ceilDiv(firsts.length, RayBatch.MAX_RAYS), (worker, job) -> {
            for (int i = job * RayBatch.MAX_RAYS; i < Math.min(firsts.length, (job + 1) * RayBatch.MAX_RAYS); i++) {
                known[i] = rays.knownSurfel(worker, firsts[i]);
            }
        }, progress.cancellationOnly());
        for (int i = 0; i < firsts.length; i++) {
            if (known[i] >= 0) {
                assert kept != null && memo != null;
                kept[known[i]] = before + i;
                surfels.set(before + i, memo.places(), known[i]);
            }
        }
        trace(rays, firsts, IntStream.range(0, firsts.length).filter(i -> known[i] < 0).toArray());
        surfels.count = before + firsts.length;
        for (int i = 0; i < firsts.length; i++) {
            int s = before + i;
            near.set(s, rays.key(firsts[i]) != cellKeys.surfelKey(surfels.px[s], surfels.py[s], surfels.pz[s], surfels.nx[s],
                    surfels.ny[s], surfels.nz[s], surfels.primitive[s], false));
        }
        return firsts;
    }

    /** Returns the ray of the lowest rank in each cell that has no surfel. */
    private int[] newCells(SurfelRays rays, int firstRay, CellTable known) {
        CellTable added = new CellTable();
        int perPoint = rays.raysPerPoint();
        int pointsPerBatch = Math.ceilDiv(BATCH, perPoint);
        int firstPoint = firstRay / perPoint;
        workers.run(Math.ceilDiv(rays.points() - firstPoint, pointsPerBatch), (_, job) -> {
            int from = firstPoint + job * pointsPerBatch;
            for (int p = from; p < Math.min(rays.points(), from + pointsPerBatch); p++) {
                long seed = rays.seed(p);
                for (int k = 0; k < perPoint; k++) {
                    int ray = p * perPoint + k;
                    if (rays.isHit(ray) && rays.mayBeFirst(ray) && known.number(rays.key(ray)) < 0) {
                        added.add(rays.key(ray), ray, rays.rank(p, seed, k));
                    }
                }
            }
        }, progress.cancellationOnly());
        int[] firsts = added.firsts();
        memory.reserve(firsts.length, bytesPerSurfel);
        return firsts;
    }

    /** Adds blocks with the rows of some new surfels. */
    private void trace(SurfelRays from, int[] firsts, int[] added) {
        int before = surfels.count;
        int[] rays = Arrays.stream(added).map(i -> firsts[i]).toArray();
        int blocksBefore = blocks.length;
        blocks = Arrays.copyOf(blocks, blocksBefore + Math.ceilDiv(added.length, RayBatch.MAX_RAYS));
        numbers = Arrays.copyOf(numbers, blocks.length);
        workers.run(blocks.length - blocksBefore, (worker, job) -> {
            int first = job * RayBatch.MAX_RAYS;
            int end = Math.min(added.length, first + RayBatch.MAX_RAYS);
            HitRows rows = from.hits(worker, rays, first, end);
            assert rows.owner != null;
            int[] number = Arrays.stream(added, first, end).map(i -> before + i).toArray();
            blocks[blocksBefore + job] = rows;
            numbers[blocksBefore + job] = number;
            for (int row = 0; row < rows.count; row++) {
                surfels.set(number[rows.parent[row]], rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                        rows.nz[row], rows.owner[row]);
            }
        }, progress.cancellationOnly());
    }

    private void number(RayLinks rays) {
        rays.allocateNumbers(surfels.count, glowing);
        workers.run(Math.ceilDiv(rays.rayCount(), BATCH),
                (_, job) -> rays.resolve(cells, job * BATCH, Math.min(rays.rayCount(), job * BATCH + BATCH)), progress.cancellationOnly());
        rays.finish();
    }
}
