package lightning.render.relight.tile;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.relight.paper.ReflectionHitList;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeCodeBuilder;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowSplice;
import lightning.render.trace.TileVisibility;

/**
 * The levels of a tile below the first: what is seen in mirrors and through clear surfaces. They are a tree, for from a row of a clear
 * material a ray goes on in two ways; they are kept in a list, a level before those that are seen from it, what is mirrored before what is
 * refracted. Traced, updated and composed for one tile after the other: one for each thread.
 */
final class BounceLevels {
    private static final TileLevel[] NONE = {};

    private final RenderJob job;
    private final LevelWorker worker;
    private final List<TileLevel> levels = new ArrayList<>();
    /** Where rows are not kept, the shapes that rays hit. */
    private final ReflectionHitList hitShapes = new ReflectionHitList();
    /** Tells anti-aliasing what is seen; null where it does not look. */
    private EdgeCodeBuilder edgeCoder;
    /** The levels before, and the next of them to be looked at. */
    private TileLevel[] oldLevels;
    private int nextOldLevel;
    private boolean changed;
    private long rayCount;

    BounceLevels(RenderJob job, LevelWorker worker) {
        this.job = job;
        this.worker = worker;
    }

    /** The rays that went on from rows since the start, in either way. */
    long rayCount() {
        return rayCount;
    }

    /**
     * What a tile keeps of them.
     *
     * @param levels all levels; only the first where the others are kept as hit shapes
     * @param images what the rays bring that go on from the first level's rows; null where none does
     */
    record TracedLevels(TileLevel[] levels, int[][] hitShapes, BounceImages images) {}

    private void begin(TileLevel top, TileLevel[] before, int[][] shapes, EdgeCodeBuilder codeBuilder) {
        levels.clear();
        levels.add(top);
        hitShapes.begin(shapes);
        edgeCoder = codeBuilder;
        oldLevels = before;
        nextOldLevel = 1;
        changed = false;
    }

    /**
     * Traces them.
     *
     * @param top   the first level
     * @param shapes the shapes that their rays hit, as far as known
     * @param codeBuilder  is told what is seen; null where anti-aliasing does not look
     */
    TracedLevels traceAll(TileLevel top, int[][] shapes, EdgeCodeBuilder codeBuilder) {
        begin(top, NONE, shapes, codeBuilder);
        trace(top.rows(), 0, 0);
        if (job.progress().isCanceled()) {
            return new TracedLevels(new TileLevel[] {top}, shapes, null);
        }
        BounceImages images = composeImages();
        return job.storesMirrorRows() ? new TracedLevels(levels.toArray(TileLevel[]::new), ReflectionHitList.NONE, images)
                : new TracedLevels(new TileLevel[] {top}, hitShapes.list(), images);
    }

    /**
     * Updates them. Of those that are kept as rows what is known stays, and rays are cast for the rest alone; others are traced from
     * the shapes that their rays hit.
     *
     * @param before the tile
     * @param top    its first level now
     * @param order  what became of that level's rows; null if they are what they were
     * @param codeBuilder   is told what is seen; null where anti-aliasing does not look
     */
    TracedLevels updateAll(CachedTile before, TileLevel top, RowSplice order, EdgeCodeBuilder codeBuilder) {
        if (!job.storesMirrorRows()) {
            return traceAll(top,
                    order == null ? ReflectionHitList.validAfter(before.hitShapes, job.plan(), job.mirrorTarget().geometry())
                            : ReflectionHitList.NONE,
                    codeBuilder);
        }
        begin(top, before.levels, ReflectionHitList.NONE, codeBuilder);
        changed = order != null || job.mirrorPlan() != null && job.mirrorPlan().recomposeAll();
        update(top.rows(), order, before.levels[0].rows(), 0, 0);
        return job.progress().isCanceled() ? new TracedLevels(before.levels, before.hitShapes, null)
                : new TracedLevels(levels.toArray(TileLevel[]::new), before.hitShapes, changed ? composeImages() : before.images);
    }

    /** Traces all that is seen from a level's rows. */
    private void trace(HitRows rows, int depth, int nodeIndex) {
        for (BounceKind bounce : BounceKind.values()) {
            if (depth < job.depth() && bounce.rowCount(rows) > 0 && !job.progress().isCanceled()) {
                trace(rows, bounce, depth, nodeIndex);
            }
        }
    }

    private void trace(HitRows rows, BounceKind bounce, int depth, int nodeIndex) {
        if (hitShapes.hasNext() && !worker.visibility().raysThroughBoxes(rows, bounce, job.shapeChange().visibleChanges()).isEmpty()) {
            // What is seen from these rows may be other rows, and then nothing is known of what is seen from theirs.
            hitShapes.dropRest();
        }
        int[] shapes = hitShapes.next();
        HitRows bounceRows = worker.visibility().traceBounceRays(rows, bounce, shapes, allocator(rows));
        rayCount += worker.visibility().rayCount();
        if (!job.storesMirrorRows()) {
            hitShapes.add(shapes == null ? worker.visibility().hitShapes() : shapes);
        }
        TileLevel level = worker.lightLevel(bounceRows);
        int childIndex = EdgeCodeBuilder.childIndex(nodeIndex, bounce);
        add(level, depth + 1, childIndex);
        trace(level.rows(), depth + 1, childIndex);
    }

    private void add(TileLevel level, int depth, int nodeIndex) {
        levels.add(level);
        if (edgeCoder != null && !job.progress().isCanceled()) {
            worker.addEdgeCodes(edgeCoder, depth, nodeIndex, level);
        }
    }

    private TileVisibility.Allocator allocator(HitRows above) {
        return (count, textured, clear) -> new HitRows(count, textured, clear, above.code != null, job.needsOwners());
    }

    /**
     * Updates all that is seen from a level's rows.
     *
     * @param order  what became of the level's rows; null if they are what they were
     * @param before the level's rows before
     */
    private void update(HitRows rows, RowSplice order, HitRows before, int depth, int nodeIndex) {
        for (BounceKind bounce : BounceKind.values()) {
            boolean existed = depth < job.depthBefore() && bounce.rowCount(before) > 0;
            boolean exists = depth < job.depth() && bounce.rowCount(rows) > 0;
            if (job.progress().isCanceled()) {
                return;
            }
            if (existed && exists) {
                BitSet retraced = worker.visibility().raysThroughBoxes(rows, bounce, job.shapeChange().visibleChanges());
                if (LevelWorker.isWorthUpdating(retraced, bounce.rowCount(rows))) {
                    update(rows, bounce, order, retraced, depth, nodeIndex);
                    continue;
                }
            }
            changed |= existed || exists;
            if (existed) {
                skipSubtree(depth + 1);
            }
            if (exists) {
                trace(rows, bounce, depth, nodeIndex);
            }
        }
    }

    /** Goes past an old level and all that was seen from it. */
    private void skipSubtree(int depth) {
        HitRows rows = oldLevels[nextOldLevel++].rows();
        for (BounceKind bounce : BounceKind.values()) {
            if (depth < job.depthBefore() && bounce.rowCount(rows) > 0) {
                skipSubtree(depth + 1);
            }
        }
    }

    /** @param retraced those of the rows whose rays may hit something else than before */
    private void update(HitRows rows, BounceKind bounce, RowSplice order, BitSet retraced, int depth, int nodeIndex) {
        TileLevel before = oldLevels[nextOldLevel++];
        RowSplice rowSplice = !retraced.isEmpty() || reordersRows(order, before.rows())
                ? RowSplice.mergeBounce(order, bounce.rowCount(rows), before.rows(), retraced, job.mirrorTarget().geometry().materials())
                : null;
        TileLevel level = rowSplice == null ? before : worker.reorder(rowSplice, before);
        if (job.mirrorPlan() != null) {
            TileLevel textured = worker.retexture(level, rows, bounce, job.mirrorPlan());
            TileLevel updated = worker.update(textured, job.mirrorPlan());
            if (job.progress().isCanceled()) {
                return;
            }
            changed |= job.mirrorPlan().canChangeColors(textured, updated.layers());
            level = updated;
        }
        BitSet unknown = order == null ? new BitSet() : order.rowsWithoutRays(bounce);
        unknown.or(retraced);
        if (!unknown.isEmpty()) {
            TileLevel added = worker.lightLevel(worker.visibility().traceSelectedBounceRays(rows, bounce, unknown, allocator(rows)));
            rayCount += worker.visibility().rayCount();
            RowSplice all = RowSplice.join(bounce.rowCount(rows), level.rows(), added.rows(), job.mirrorTarget().geometry().materials());
            level = worker.join(all, level, added);
            rowSplice = rowSplice == null ? all : rowSplice.andThen(all);
        }
        int childIndex = EdgeCodeBuilder.childIndex(nodeIndex, bounce);
        add(level, depth + 1, childIndex);
        changed |= rowSplice != null;
        update(level.rows(), rowSplice, before.rows(), depth + 1, childIndex);
    }

    /** Whether rows that are seen from others change their places, or are seen no more. */
    private boolean reordersRows(RowSplice above, HitRows rows) {
        return above != null || job.mirrorPlan() != null && job.mirrorPlan().materials().mirroringChanged().intersects(rows);
    }

    /** Composes all of them; what the rays bring that go on from the first level's rows. */
    private BounceImages composeImages() {
        nextOldLevel = 1;
        BounceImages images = composeImages(levels.getFirst().rows(), 0);
        return images == null ? null : images.compact(levels.getFirst().rows());
    }

    private BounceImages composeImages(HitRows rows, int depth) {
        if (depth == job.depth() || rows.reflectiveCount == 0) {
            return worker.composer.blackImages(rows, depth);
        }
        BounceImages images = worker.composer.backgroundImages(rows, job.mirrorTarget().scene().world(), depth);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0) {
                int at = nextOldLevel++;
                BounceImages below = composeImages(levels.get(at).rows(), depth + 1);
                levels.set(at,
                        worker.compose(levels.get(at), job.storesMirrorRows() ? job.mirrorPlan() : null, below, images.forBounce(bounce)));
            }
        }
        return images;
    }

    /**
     * Asks again what all rays hit that go on from the rows of a tile as it was; of each level something follows.
     *
     * @param top the first level, of which it follows already
     */
    TileLevel[] retraceHits(CachedTile tile, TileLevel top, boolean detectEdges, RetraceHandler answer) {
        begin(top, tile.levels, ReflectionHitList.NONE, null);
        retrace(top.rows(), 0, detectEdges, answer);
        return levels.toArray(TileLevel[]::new);
    }

    /** What follows from rows that were traced again, for a level whose rows they are, perhaps in another order. */
    @FunctionalInterface
    interface RetraceHandler {
        TileLevel apply(TileLevel level, HitRows retracedRows);
    }

    private void retrace(HitRows rows, int depth, boolean detectEdges, RetraceHandler answer) {
        for (BounceKind bounce : BounceKind.values()) {
            if (depth < job.depthBefore() && bounce.rowCount(rows) > 0 && nextOldLevel < oldLevels.length) {
                HitRows retracedRows = worker.visibility().traceBounceRays(rows, bounce, null,
                        (count, textured, clear) -> new HitRows(count, textured, clear, detectEdges, job.needsOwners()));
                rayCount += worker.visibility().rayCount();
                TileLevel level = answer.apply(oldLevels[nextOldLevel++], retracedRows);
                levels.add(level);
                retrace(level.rows(), depth + 1, detectEdges, answer);
            }
        }
    }
}
