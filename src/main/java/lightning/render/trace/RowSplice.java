package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.column.ColumnKind;
import lightning.render.column.ColumnSet;
import org.jspecify.annotations.Nullable;

/**
 * Merge of a level's existing rows with newly traced ones; some existing rows may be removed. Lets a material become
 * reflective, or stop being so, without tracing known rays again.
 *
 * <p>The result has the order of a fresh trace: by material, reflective materials first, then by parent.
 */
public final class RowSplice {
    private final HitRows old;
    private final @Nullable HitRows added;
    private HitRows rows;
    /** For each resulting row the old row, or {@code ~i} for added row i. */
    private final int[] source;
    /** For each resulting row the end of its range of consecutive sources, which is copied in one step. */
    private final int[] end;
    /** For each old row its resulting row, or −1. */
    private final int[] newIndex;
    private final int reflectiveCount;
    private final int clearCount;

    /**
     * @param order rows in the order within one material, encoded as in {@link #source}
     * @param count number of rows
     */
    private RowSplice(HitRows old, @Nullable HitRows added, int[] order, int count, MaterialTable materials) {
        this.old = old;
        this.added = added;
        int[] oldRanks = ranks(old, materials);
        int[] addedRanks = added == null ? null : ranks(added, materials);
        int[] starts = new int[materials.count() + 1];
        for (int i = 0; i < count; i++) {
            int s = order[i];
            starts[(s < 0 ? requireNonNull(addedRanks)[~s] : oldRanks[s]) + 1]++;
        }
        for (int r = 0; r < materials.count(); r++) {
            starts[r + 1] += starts[r];
        }
        int[] ends = starts.clone();
        reflectiveCount = starts[materials.reflectiveCount()];
        clearCount = starts[materials.clearCount()];
        source = new int[count];
        newIndex = new int[old.count];
        Arrays.fill(newIndex, -1);
        for (int i = 0; i < count; i++) {
            int s = order[i];
            int row = starts[s < 0 ? requireNonNull(addedRanks)[~s] : oldRanks[s]]++;
            source[row] = s;
            if (s >= 0) {
                newIndex[s] = row;
            }
        }
        end = ends(source);
        rows = isUnchanged() ? old : allocateRows(ends, materials);
    }

    /** Returns whether all old rows keep their positions and none were added; then columns are shared without copying. */
    public boolean isUnchanged() {
        return added == null && source.length == old.count && (source.length == 0 || source[0] == 0 && end[0] == source.length);
    }

    /** @param ends exclusive end row of each rank, all lower ranks included */
    private HitRows allocateRows(int[] ends, MaterialTable materials) {
        TexelColumns needed = TexelColumns.NONE;
        for (int r = 0; r < materials.count(); r++) {
            needed = ends[r + 1] > ends[r] ? needed.or(materials.texels(materials.materialAtRank(r))) : needed;
        }
        TexelColumns known = added == null ? old.texels() : old.texels().or(added.texels());
        HitRows allocated = new HitRows(source.length, needed.and(known), clearCount > 0, old.pattern != null, old.owner != null);
        allocated.count = source.length;
        allocated.reflectiveCount = reflectiveCount;
        allocated.clearCount = clearCount;
        for (int r = 0; r < materials.count(); r++) {
            if (ends[r + 1] > ends[r]) {
                allocated.addRun(materials.materialAtRank(r), ends[r + 1]);
            }
        }
        return allocated;
    }

    private static int[] ends(int[] source) {
        int[] end = new int[source.length];
        for (int i = source.length - 1; i >= 0; i--) {
            // Indices of added rows count down: ~0, ~1, ….
            boolean follows = i + 1 < source.length && source[i + 1] == (source[i] < 0 ? source[i] - 1 : source[i] + 1)
                    && source[i] < 0 == source[i + 1] < 0;
            end[i] = follows ? end[i + 1] : i + 1;
        }
        return end;
    }

    /** Returns for each row the rank of its material. */
    private static int[] ranks(HitRows rows, MaterialTable materials) {
        int[] ranks = new int[rows.count];
        for (int r = 0; r < rows.runCount; r++) {
            Arrays.fill(ranks, rows.runStart(r), rows.runEnd[r], materials.rank(rows.runMaterial[r]));
        }
        return ranks;
    }

    /**
     * Returns the same rows in the order of other materials.
     *
     * @param retraced parents of removed rows, whose rays are traced again
     */
    public static RowSplice sort(HitRows old, BitSet retraced, MaterialTable materials) {
        int[] remaining = new int[old.count];
        int count = 0;
        for (int i = 0; i < old.count; i++) {
            remaining[count] = i;
            count += retraced.get(old.parent[i]) ? 0 : 1;
        }
        var splice = new RowSplice(old, null, remaining, count, materials);
        splice.copy(old.parent);
        return splice;
    }

    /**
     * Returns the rows that rays of one kind from the previous level hit.
     *
     * @param parentSplice splice of the previous level; null if its rows are unchanged
     * @param rays number of rows of the previous level that cast these rays now
     * @param retraced rows of the previous level, by new index, whose rays are traced again; their old hits are removed
     */
    public static RowSplice mergeBounce(@Nullable RowSplice parentSplice, int rays, HitRows old, BitSet retraced, MaterialTable materials) {
        return mergeBounce(parentSplice, rays, old, retraced, null, materials);
    }

    /**
     * Joins existing rows and newly traced rows.
     *
     * @param rays number of parents
     * @param added rows of other parents
     */
    public static RowSplice join(int rays, HitRows old, HitRows added, MaterialTable materials) {
        return mergeBounce(null, rays, old, new BitSet(), added, materials);
    }

    private static RowSplice mergeBounce(@Nullable RowSplice parentSplice, int rays, HitRows old, BitSet retraced, @Nullable HitRows added,
            MaterialTable materials) {
        int[] sources = new int[rays];
        Arrays.fill(sources, Integer.MIN_VALUE);
        short[] parents = new short[HitRows.paddedLength(old.count)];
        for (int i = 0; i < old.count; i++) {
            int parent = parentSplice == null ? old.parent[i] : parentSplice.newIndex[old.parent[i]];
            parents[i] = (short) parent;
            if (parent >= 0 && parent < rays && !retraced.get(parent)) {
                sources[parent] = i;
            }
        }
        for (int i = 0; added != null && i < added.count; i++) {
            sources[added.parent[i]] = ~i;
        }
        int count = 0;
        for (int s : sources) {
            if (s != Integer.MIN_VALUE) {
                sources[count++] = s;
            }
        }
        var splice = new RowSplice(old, added, sources, count, materials);
        splice.copy(parents);
        return splice;
    }

    private void copy(short[] oldParents) {
        HitRows from = old.withParents(oldParents, reflectiveCount);
        if (isUnchanged()) {
            rows = from;
        } else {
            fill(rows.columns(), from.columns(), added == null ? null : added.columns());
        }
    }

    /** Returns the resulting rows. */
    public HitRows rows() {
        return rows;
    }

    /** Returns this splice and the next one as one step: the remaining old rows with all rows added since. */
    public RowSplice andThen(RowSplice next) {
        return new RowSplice(this, next);
    }

    private RowSplice(RowSplice first, RowSplice second) {
        old = first.old;
        added = second.added;
        reflectiveCount = second.reflectiveCount;
        clearCount = second.clearCount;
        rows = second.rows;
        source = new int[second.source.length];
        Arrays.setAll(source, i -> second.source[i] < 0 ? second.source[i] : first.source[second.source[i]]);
        end = ends(source);
        newIndex = new int[first.newIndex.length];
        Arrays.setAll(newIndex, i -> first.newIndex[i] < 0 ? -1 : second.newIndex[first.newIndex[i]]);
    }

    /** Returns the rows whose secondary ray of a kind is unknown: they are new or cast none before. */
    public BitSet rowsWithoutRays(BounceKind bounce) {
        BitSet found = new BitSet();
        for (int i = 0; i < bounce.rowCount(rows); i++) {
            found.set(i, source[i] < 0 || source[i] >= bounce.rowCount(old));
        }
        return found;
    }

    /**
     * Fills columns over the resulting rows.
     *
     * @param columns columns to fill; where a source column below is missing, its rows keep their values
     * @param oldColumns columns over the old rows
     * @param addedColumns columns over the added rows; unused if there are none
     */
    public <C extends Enum<C> & ColumnKind> void fill(ColumnSet<C> columns, ColumnSet<C> oldColumns, @Nullable ColumnSet<C> addedColumns) {
        for (int i = 0; i < source.length; i = end[i]) {
            if (source[i] < 0) {
                columns.copy(requireNonNull(addedColumns), ~source[i], i, end[i] - i);
            } else {
                columns.copy(oldColumns, source[i], i, end[i] - i);
            }
        }
    }
}
