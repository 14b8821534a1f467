package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.TileLevel;
import lightning.render.gather.GatherStructure;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;

/** Update of the surfels' levels after an edit of objects or materials: rows that stay keep their layers as far as the plan allows. */
final class SurfelUpdate {
    /** With more blocks than this per full block, all rows are built again. */
    private static final int MAX_SPLIT = 2;
    private static final int MAX_ADDED = 8;

    private final IndirectCache before;
    private final GatherStructure after;
    private final TileLevel[] keptLevels;
    private final int[][] keptNumbers;
    private final List<TileLevel> levels = new ArrayList<>();
    private final List<int[]> numbers = new ArrayList<>();

    /** @param after paths after the edit, with the rows of new surfels */
    SurfelUpdate(IndirectCache before, GatherStructure after) {
        this.before = before;
        this.after = after;
        keptLevels = new TileLevel[before.surfels().length];
        keptNumbers = new int[keptLevels.length][];
    }

    /** Returns whether the surfels are in few enough blocks to keep them. */
    static boolean isCompact(IndirectCache indirect) {
        return indirect.surfels().length
                <= MAX_SPLIT * Math.ceilDiv(indirect.structure().surfelCount(), RayBatch.MAX_RAYS) + MAX_ADDED;
    }

    /** Updates the rows of a block that stay. Any thread may update any block. */
    void keep(int block, LevelWorker worker, RenderJob job) {
        TileLevel level = before.surfels()[block];
        int[] old = before.structure().numbers(block);
        int[] kept = requireNonNull(after.kept());
        int[] number = Arrays.stream(old).map(surfel -> surfel < 0 ? -1 : kept[surfel]).toArray();
        BitSet removed = new BitSet();
        for (int row = 0; row < level.rows().count; row++) {
            int parent = level.rows().parent[row];
            removed.set(parent, number[parent] < 0);
        }
        if (removed.cardinality() == level.rows().count) {
            return;
        }
        ShapeChange shapes = job.shapeChange();
        LevelPlan plan = requireNonNull(job.topPlan());
        TileLevel owned = shapes.hasSameIndices() ? level : level.withOwner(shapes.mapIndices(requireNonNull(level.rows().owner)));
        boolean isSorted = removed.isEmpty() && !plan.materials().mirroringChanged().intersects(level.rows());
        TileLevel sorted = isSorted ? owned
                : worker.reorder(RowSplice.sort(owned.rows(), removed, job.target().geometry().materials()), owned);
        keptLevels[block] = before.structure().bounces() > 0 ? worker.update(sorted, plan) : sorted;
        keptNumbers[block] = number;
    }

    /** Adds the levels of new surfels, in the blocks of the paths. */
    void add(TileLevel[] added) {
        for (int block = 0; block < keptLevels.length; block++) {
            if (keptLevels[block] != null) {
                levels.add(keptLevels[block]);
                numbers.add(keptNumbers[block]);
            }
        }
        for (int block = 0; block < added.length; block++) {
            levels.add(added[block]);
            numbers.add(after.numbers(block));
        }
    }

    TileLevel[] surfels() {
        return levels.toArray(TileLevel[]::new);
    }

    GatherStructure structure() {
        return after.withSurfels(levels.stream().map(TileLevel::rows).toArray(HitRows[]::new), numbers.toArray(int[][]::new));
    }
}
