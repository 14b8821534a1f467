package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.relight.paper.ReflectionHitList;
import lightning.render.shading.BounceImages;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.BounceColumns;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.BounceStart;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.RowSplice;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import org.jspecify.annotations.Nullable;

/**
 * Bounce levels of a tile, below the first level: everything seen in mirrors and through clear surfaces. They form a tree, because
 * a row of a clear material sends two rays. The tree is stored as a list in preorder, mirrored levels before refracted ones.
 * Traces, updates and composes one tile after the other: use one instance per thread.
 */
final class BounceLevels {
    private static final TileLevel[] NONE = {};

    private final RenderJob job;
    private final LevelWorker worker;
    private final @Nullable BounceFog fog;
    private final List<TileLevel> levels = new ArrayList<>();
    /** Hit shapes of the rays, used if rows are not stored. */
    private final ReflectionHitList hitShapes = new ReflectionHitList();
    /** Old levels, and the index of the next one. */
    private TileLevel[] oldLevels = NONE;
    private int nextOldLevel;
    private boolean changed;
    /** True if the colors by which edges are detected may have changed. */
    private boolean changedEdges;
    private long rayCount;

    BounceLevels(RenderJob job, LevelWorker worker) {
        this.job = job;
        fog = BounceFog.of(job.mirrorTarget().scene(), job.bounceFog());
        this.worker = worker;
    }

    /** Returns the number of rays bounced from rows since the start. */
    long rayCount() {
        return rayCount;
    }

    /**
     * Levels that a tile stores.
     *
     * @param levels       all levels; only the first if the others are stored as hit shapes
     * @param images       colors of the rays that bounce from the first level's rows; null if there are none
     * @param changesEdges true if the colors by which edges are detected may differ from those of the old levels
     */
    record TracedLevels(TileLevel[] levels, int[][] hitShapes, @Nullable BounceImages images, boolean changesEdges) {}

    private void begin(TileLevel top, TileLevel[] before, int[][] shapes) {
        levels.clear();
        levels.add(top);
        hitShapes.begin(shapes);
        oldLevels = before;
        nextOldLevel = 1;
        changed = false;
        changedEdges = false;
    }

    /**
     * Traces all levels.
     *
     * @param places image positions of the first level's rays
     * @param top    the first level
     * @param shapes cached hit shapes of the rays
     */
    TracedLevels traceAll(SamplePositions places, TileLevel top, int[][] shapes) {
        begin(top, NONE, shapes);
        trace(top.rows(), 0);
        if (job.progress().isCanceled()) {
            return new TracedLevels(new TileLevel[] {top}, shapes, null, true);
        }
        BounceImages images = composeImages(places);
        return job.storesMirrorRows() ? new TracedLevels(levels.toArray(TileLevel[]::new), ReflectionHitList.NONE, images, true)
                : new TracedLevels(new TileLevel[] {top}, hitShapes.list(), images, true);
    }

    /**
     * Updates all levels. Levels stored as rows keep cached rows and cast rays only for the rest; others are traced from their hit
     * shapes.
     *
     * @param places image positions of the first level's rays
     * @param before the old tile
     * @param top    its new first level
     * @param order  splice of that level's rows; null if they are unchanged
     */
    TracedLevels updateAll(SamplePositions places, CachedTile before, TileLevel top, @Nullable RowSplice order) {
        if (!job.storesMirrorRows()) {
            return traceAll(places, top,
                    order == null
                            ? ReflectionHitList.validAfter(before.hitShapes, requireNonNull(job.plan()), job.mirrorTarget().geometry())
                            : ReflectionHitList.NONE);
        }
        begin(top, before.levels, ReflectionHitList.NONE);
        changed = order != null || job.mirrorPlan() != null && job.mirrorPlan().recomposeAll();
        changedEdges = changed;
        changed |= job.changesBounceFog();
        update(top.rows(), order, before.levels[0].rows(), 0);
        if (job.progress().isCanceled()) {
            return new TracedLevels(before.levels, before.hitShapes, null, true);
        }
        // Composing caches partial sums and terms in the levels.
        BounceImages images = changed ? composeImages(places) : before.images;
        return new TracedLevels(levels.toArray(TileLevel[]::new), before.hitShapes, images, changedEdges);
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
            changedEdges |= existed || exists;
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
            changed |= job.mirrorPlan().canChangeColors(textured, updated.layers());
            changedEdges |= job.mirrorPlan().canChangeEdges(textured, updated.layers());
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
        changed |= rowSplice != null || job.mirroredIndirectChange().changesColors(level.weights());
        changedEdges |= rowSplice != null || job.mirroredIndirectChange().changesEdges(level.weights());
        update(level.rows(), rowSplice, before.rows(), depth + 1);
    }

    /** Returns whether rows seen from other rows move or disappear. */
    private boolean reordersRows(@Nullable RowSplice above, HitRows rows) {
        return above != null || job.mirrorPlan() != null && job.mirrorPlan().materials().mirroringChanged().intersects(rows);
    }

    /** Composes all levels; returns the colors of the rays that bounce from the first level's rows. */
    private @Nullable BounceImages composeImages(SamplePositions places) {
        nextOldLevel = 1;
        HitRows top = levels.getFirst().rows();
        BounceImages images = composeImages(top, fog == null ? null : fog.start(places, top), 0);
        return images == null ? null : images.compact(top);
    }

    /** @param start the rows as the start of bounced rays; null if these show no light in fog */
    private @Nullable BounceImages composeImages(HitRows rows, @Nullable BounceStart start, int depth) {
        if (depth == job.depth() || rows.reflectiveCount == 0) {
            return worker.composer.blackImages(rows);
        }
        BounceImages images = worker.composer.backgroundImages(rows, job.mirrorTarget().scene().world(), depth);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0) {
                int at = nextOldLevel++;
                HitRows seen = levels.get(at).rows();
                BounceImages below = composeImages(seen, start == null ? null : start.below(bounce, seen), depth + 1);
                levels.set(at,
                        worker.compose(levels.get(at), job.storesMirrorRows() ? job.mirrorPlan() : null, below,
                                requireNonNull(images).forBounce(bounce)));
                if (fog != null) {
                    MaterialTable materials = job.mirrorTarget().geometry().materials();
                    WeightedLight[] lights = job.mirrorTarget().lights();
                    BounceColumns columns = fog.columns(rows, seen, bounce, materials, start, lights, levels.get(at).fog());
                    levels.set(at, levels.get(at).withFog(columns));
                    fog.add(rows, seen, bounce, materials, columns, lights, images.forBounce(bounce));
                }
            }
        }
        return images;
    }

    /** Returns all levels of the tile that was traced or updated last. */
    TileLevel[] lastLevels() {
        return levels.toArray(TileLevel[]::new);
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
        begin(top, tile.levels, ReflectionHitList.NONE);
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
