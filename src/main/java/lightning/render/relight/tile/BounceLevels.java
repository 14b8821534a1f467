package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.relight.paper.ReflectionHitList;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowSplice;
import lightning.render.trace.TileVisibility;
import org.jspecify.annotations.Nullable;

/**
 * Bounce levels of a tile, below the first level: everything seen in mirrors and through clear surfaces. They form a tree, because
 * a row of a clear material sends two rays. The tree is stored as a list in preorder, mirrored levels before refracted ones.
 * Traces and updates one tile after the other: use one instance per thread.
 */
final class BounceLevels {
    private static final TileLevel[] NONE = {};

    private final RenderJob job;
    private final LevelWorker worker;
    private final List<TileLevel> levels = new ArrayList<>();
    /** Hit shapes of the rays, used if rows are not stored. */
    private final ReflectionHitList hitShapes = new ReflectionHitList();
    /** Old levels, and the index of the next one. */
    private TileLevel[] oldLevels = NONE;
    private int nextOldLevel;
    private boolean changed;
    private long rayCount;

    BounceLevels(RenderJob job, LevelWorker worker) {
        this.job = job;
        this.worker = worker;
    }

    /** Returns the number of rays bounced from rows since the start. */
    long rayCount() {
        return rayCount;
    }

    /**
     * Levels that a tile stores.
     *
     * @param levels    all levels; only the first if the others are stored as hit shapes
     * @param hitShapes otherwise empty
     * @param isChanged whether any row differs from the old levels
     * @param all       all levels, as far as they are known
     */
    record TracedLevels(TileLevel[] levels, int[][] hitShapes, boolean isChanged, TileLevel[] all) {
        // Arrays in a record: written once by their creator, never after.

        /** Returns the levels of a tile without bounced rays. */
        static TracedLevels only(TileLevel top, boolean isChanged) {
            TileLevel[] levels = {top};
            return new TracedLevels(levels, ReflectionHitList.NONE, isChanged, levels);
        }

        /** Returns a copy of all levels as far as they are known, with a first one. */
        TileLevel[] allLevels(TileLevel top) {
            TileLevel[] copy = all.clone();
            copy[0] = top;
            return copy;
        }
    }

    private void begin(TileLevel top, TileLevel[] before, int[][] shapes) {
        levels.clear();
        levels.add(top);
        hitShapes.begin(shapes);
        oldLevels = before;
        nextOldLevel = 1;
        changed = false;
    }

    /**
     * Traces all levels.
     *
     * @param top    the first level
     * @param shapes cached hit shapes of the rays
     */
    TracedLevels traceAll(TileLevel top, int[][] shapes) {
        begin(top, NONE, shapes);
        trace(top.rows(), 0);
        TileLevel[] all = levels.toArray(TileLevel[]::new);
        return job.storesMirrorRows() ? new TracedLevels(all, ReflectionHitList.NONE, true, all)
                : new TracedLevels(new TileLevel[] {top}, hitShapes.list(), true, all);
    }

    /**
     * Updates all levels. Levels stored as rows keep cached rows and cast rays only for the rest; others are traced from their hit
     * shapes.
     *
     * @param before the old tile
     * @param top    its new first level
     * @param order  splice of that level's rows; null if they are unchanged
     */
    TracedLevels updateAll(CachedTile before, TileLevel top, @Nullable RowSplice order) {
        if (!job.storesMirrorRows()) {
            return traceAll(top,
                    order == null
                            ? ReflectionHitList.validAfter(before.hitShapes(), requireNonNull(job.plan()), job.mirrorTarget().geometry())
                            : ReflectionHitList.NONE);
        }
        begin(top, before.levels(), ReflectionHitList.NONE);
        changed = order != null;
        update(top.rows(), order, before.levels()[0].rows(), 0);
        TileLevel[] all = levels.toArray(TileLevel[]::new);
        return new TracedLevels(all, before.hitShapes(), changed, all);
    }

    /** Returns the levels of a tile whose rows stay. Rows that were last composed with the light of other paths get the weights of its points. */
    TracedLevels keep(CachedTile tile) {
        TileLevel[] kept = tile.levels().clone();
        for (int i = 1; i < kept.length; i++) {
            kept[i] = worker.withWeights(kept[i]);
        }
        return new TracedLevels(kept, tile.hitShapes(), false, kept);
    }

    /** Traces everything seen from a level's rows. */
    private void trace(HitRows rows, int depth) {
        for (BounceKind bounce : BounceKind.values()) {
            if (depth < job.depth() && bounce.rowCount(rows) > 0 && !job.progress().isCanceled()) {
                trace(rows, bounce, depth);
            }
        }
    }

    private void trace(HitRows rows, BounceKind bounce, int depth) {
        if (hitShapes.hasNext() && !worker.visibility().raysThroughBoxes(rows, bounce, job.shapeChange().visibleChanges()).isEmpty()) {
            // Other rows may be visible from these rows, so the cached levels seen from them are invalid.
            hitShapes.dropRest();
        }
        int[] shapes = hitShapes.next();
        HitRows bounceRows = worker.visibility().traceBounceRays(rows, bounce, shapes, allocator(rows));
        rayCount += worker.visibility().rayCount();
        if (!job.storesMirrorRows()) {
            hitShapes.add(shapes == null ? worker.visibility().hitShapes() : shapes);
        }
        TileLevel level = worker.withWeights(worker.lightLevel(bounceRows));
        levels.add(level);
        trace(level.rows(), depth + 1);
    }

    private TileVisibility.Allocator allocator(HitRows above) {
        return (count, texels, clear) -> new HitRows(count, texels, clear, above.pattern != null, job.needsOwners());
    }

    /**
     * Updates everything seen from a level's rows.
     *
     * @param order  splice of the level's rows; null if they are unchanged
     * @param before the level's old rows
     */
    private void update(HitRows rows, @Nullable RowSplice order, HitRows before, int depth) {
        for (BounceKind bounce : BounceKind.values()) {
            boolean existed = depth < job.depthBefore() && bounce.rowCount(before) > 0;
            boolean exists = depth < job.depth() && bounce.rowCount(rows) > 0;
            if (job.progress().isCanceled()) {
                return;
            }
            if (existed && exists) {
                BitSet retraced = worker.visibility().raysThroughBoxes(rows, bounce, job.shapeChange().visibleChanges());
                if (LevelWorker.isWorthUpdating(retraced, bounce.rowCount(rows))) {
                    update(rows, bounce, order, retraced, depth);
                    continue;
                }
            }
            changed |= existed || exists;
            if (existed) {
                skipSubtree(depth + 1);
            }
            if (exists) {
                trace(rows, bounce, depth);
            }
        }
    }

    /** Skips an old level and everything seen from it. */
    private void skipSubtree(int depth) {
        HitRows rows = oldLevels[nextOldLevel++].rows();
        for (BounceKind bounce : BounceKind.values()) {
            if (depth < job.depthBefore() && bounce.rowCount(rows) > 0) {
                skipSubtree(depth + 1);
            }
        }
    }

    /** @param retraced rows whose rays may have another hit than before */
    private void update(HitRows rows, BounceKind bounce, @Nullable RowSplice order, BitSet retraced, int depth) {
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
        level = worker.withWeights(level);
        levels.add(level);
        changed |= rowSplice != null;
        update(level.rows(), rowSplice, before.rows(), depth + 1);
    }

    /** Returns whether rows seen from other rows move or disappear. */
    private boolean reordersRows(@Nullable RowSplice above, HitRows rows) {
        return above != null || job.mirrorPlan() != null && job.mirrorPlan().materials().mirroringChanged().intersects(rows);
    }

    /** Returns levels of a tile, below the first with the terms of their lights. */
    TileLevel[] withTerms(TileLevel[] all) {
        TileLevel[] terms = new TileLevel[all.length];
        Arrays.setAll(terms, i -> i == 0 ? all[0] : worker.withTerms(all[i]));
        return terms;
    }

    /**
     * Traces all rays that bounce from the rows of an unchanged tile again and lets a handler convert each level.
     *
     * @param top the converted first level
     */
    TileLevel[] retraceHits(CachedTile tile, TileLevel top, RetraceHandler handler) {
        begin(top, tile.levels(), ReflectionHitList.NONE);
        retrace(top.rows(), 0, handler);
        return levels.toArray(TileLevel[]::new);
    }

    /** Converts a level whose rays were traced again; the rows may be in another order. */
    @FunctionalInterface
    interface RetraceHandler {
        TileLevel apply(TileLevel level, HitRows retracedRows);
    }

    private void retrace(HitRows rows, int depth, RetraceHandler handler) {
        for (BounceKind bounce : BounceKind.values()) {
            if (depth < job.depthBefore() && bounce.rowCount(rows) > 0 && nextOldLevel < oldLevels.length) {
                HitRows retracedRows = worker.visibility().traceBounceRays(rows, bounce, null,
                        allocator(rows));
                rayCount += worker.visibility().rayCount();
                TileLevel level = handler.apply(oldLevels[nextOldLevel++], retracedRows);
                levels.add(level);
                retrace(level.rows(), depth + 1, handler);
            }
        }
    }
}
