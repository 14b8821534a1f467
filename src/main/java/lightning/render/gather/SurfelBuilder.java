package lightning.render.gather;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.RayBatch;

/**
 * Divides what rays hit into surfels, and links surfels by rays of their own for further bounces. Surfels that only a later bounce meets
 * are numbered after those before.
 */
final class SurfelBuilder {
    private static final int BATCH = 1 << 14;

    private final WorkerPool workers;
    private final Progress progress;
    private final GatherCaster[] surfelCasters;
    private final int pointsPerBatch;
    private final CellTable cells = CellTable.ofLowest();
    private final CellColors colors;
    private final MaterialTable materials;
    private final SurfaceColumns surfels = new SurfaceColumns();
    private long[] seeds = {};
    HitRows[] blocks = {};
    /** First surfel of each block. */
    int[] blockStart = {};
    final RayLinks links;

    /**
     * @param directions of the surfels' rays
     * @param colors     texture colors that all rays hit
     */
    SurfelBuilder(WorkerPool workers, Progress progress, GatherCaster[] surfelCasters, DirectionTable directions, MaterialTable materials,
            CellColors colors) {
        this.workers = workers;
        this.progress = progress;
        this.surfelCasters = surfelCasters;
        this.materials = materials;
        this.colors = colors;
        pointsPerBatch = GatherCaster.pointsPerBatch(directions);
        links = new RayLinks(directions.rays());
        links.setPoints(0);
    }

    int count() {
        return surfels.count;
    }

    /**
     * Builds all surfels.
     *
     * @param pointCasters of the gather points' rays
     */
    void build(SurfaceColumns points, long[] pointSeeds, RayLinks pointLinks, GatherCaster[] pointCasters, int bounces) {
        addSurfels(points, pointSeeds, pointLinks, 0, pointCasters);
        int linked = 0;
        for (int bounce = 2; bounce <= bounces && linked < surfels.count; bounce++) {
            int from = linked;
            int to = surfels.count;
            links.setPoints(to);
            workers.run(Math.ceilDiv(to - from, pointsPerBatch), (worker, job) -> {
                int first = from + job * pointsPerBatch;
                surfelCasters[worker].cast(surfels, seeds, first, Math.min(to, first + pointsPerBatch), links, null);
            }, progress.cancellationOnly());
            addSurfels(surfels, seeds, links, from * links.raysPerPoint(), surfelCasters);
            linked = to;
        }
        number(pointLinks);
        number(links);
        workers.run(blocks.length, (_, block) -> averageColors(block), progress.cancellationOnly());
    }

    /** Gives the surfels of a block the mean texture colors of their cells. */
    private void averageColors(int block) {
        HitRows rows = blocks[block];
        for (int run = 0; run < rows.runCount; run++) {
            if (materials.isTextured(rows.runMaterial[run])) {
                for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
                    long cell = cell(blockStart[block] + rows.parent[row]);
                    rows.texelRed[row] = colors.mean(cell, 0);
                    rows.texelGreen[row] = colors.mean(cell, 1);
                    rows.texelBlue[row] = colors.mean(cell, 2);
                }
            }
        }
    }

    /** Returns the cell of a surfel. */
    private long cell(int surfel) {
        return seeds[surfel] - 1;
    }

    /** Adds a surfel for each new cell that some rays hit, in the order of the rays that come first. */
    private void addSurfels(SurfaceColumns sources, long[] sourceSeeds, RayLinks rays, int firstRay, GatherCaster[] casters) {
        CellTable added = CellTable.ofRandom();
        int end = rays.rayCount();
        workers.run(Math.ceilDiv(end - firstRay, BATCH), (_, job) -> {
            int from = firstRay + job * BATCH;
            for (int ray = from; ray < Math.min(end, from + BATCH); ray++) {
                if (rays.isHit(ray) && cells.number(rays.key(ray)) < 0) {
                    added.add(rays.key(ray), ray);
                }
            }
        }, progress.cancellationOnly());
        int[] firsts = added.firsts();
        int before = surfels.count;
        surfels.reserve(before + firsts.length);
        long[] newSeeds = Arrays.copyOf(seeds, before + firsts.length);
        for (int i = 0; i < firsts.length; i++) {
            long key = rays.key(firsts[i]);
            cells.add(key, firsts[i]);
            cells.setNumber(key, before + i);
            newSeeds[before + i] = key + 1;
        }
        int blocksBefore = blocks.length;
        HitRows[] all = Arrays.copyOf(blocks, blocksBefore + Math.ceilDiv(firsts.length, RayBatch.MAX_RAYS));
        blockStart = Arrays.copyOf(blockStart, all.length);
        for (int block = blocksBefore; block < all.length; block++) {
            blockStart[block] = before + (block - blocksBefore) * RayBatch.MAX_RAYS;
        }
        workers.run(all.length - blocksBefore, (worker, job) -> {
            int from = job * RayBatch.MAX_RAYS;
            HitRows rows = casters[worker].hits(sources, sourceSeeds, firsts, from, Math.min(firsts.length, from + RayBatch.MAX_RAYS));
            all[blocksBefore + job] = rows;
            for (int row = 0; row < rows.count; row++) {
                surfels.set(before + from + rows.parent[row], rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                        rows.nz[row], rows.owner[row]);
            }
        }, progress.cancellationOnly());
        surfels.count = before + firsts.length;
        seeds = newSeeds;
        blocks = all;
    }

    private void number(RayLinks rays) {
        rays.allocateNumbers();
        workers.run(Math.ceilDiv(rays.rayCount(), BATCH),
                (_, job) -> rays.resolve(cells, job * BATCH, Math.min(rays.rayCount(), job * BATCH + BATCH)), progress.cancellationOnly());
        rays.finish();
    }
}
