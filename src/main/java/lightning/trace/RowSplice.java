package lightning.trace;

import java.util.Arrays;
import lightning.column.ColumnKind;
import lightning.column.ColumnSet;

/**
 * How the rows of a tile's level come from rows that are there already, some of which may go, and from rows that were
 * traced since: what it takes to let a material begin or cease to mirror without tracing what is known.
 *
 * <p>The result has the order of a fresh trace: by material, mirrors first, and by parent.
 */
public final class RowSplice {
    private final HitRows old;
    private final HitRows added;
    private HitRows rows;
    /** Of each row of the result the old row, or {@code ~i} for row i of those added. */
    private final int[] source;
    /** Of each row of the result the end of the stretch whose sources follow one another, which is copied at once. */
    private final int[] end;
    /** Of each old row its row in the result, or −1. */
    private final int[] now;
    private final int reflective;
    private final int clear;

    /** @param sequence rows in the order that rows of one material keep, as {@link #source} */
    private RowSplice(HitRows old, HitRows added, int[] sequence, MaterialTable materials) {
        this.old = old;
        this.added = added;
        int[] oldMaterials = materials(old);
        int[] addedMaterials = added == null ? new int[0] : materials(added);
        int[] starts = new int[materials.count() + 1];
        for (int s : sequence) {
            starts[materials.rank(s < 0 ? addedMaterials[~s] : oldMaterials[s]) + 1]++;
        }
        for (int r = 0; r < materials.count(); r++) {
            starts[r + 1] += starts[r];
        }
        int[] ends = starts.clone();
        reflective = starts[materials.reflectiveCount()];
        clear = starts[materials.clearCount()];
        source = new int[sequence.length];
        now = new int[old.count];
        Arrays.fill(now, -1);
        for (int s : sequence) {
            int row = starts[materials.rank(s < 0 ? addedMaterials[~s] : oldMaterials[s])]++;
            source[row] = s;
            if (s >= 0) {
                now[s] = row;
            }
        }
        end = ends(source);
        if (!keepsRows()) {
            rows = room(ends, materials);
        }
    }

    /** Whether all old rows stay where they are and none came: columns are shared, and none need be copied. */
    public boolean keepsRows() {
        return added == null && source.length == old.count && (source.length == 0 || source[0] == 0 && end[0] == source.length);
    }

    /** @param ends for each rank the row behind the rows of all lower ranks */
    private HitRows room(int[] ends, MaterialTable materials) {
        boolean textured = false;
        for (int r = 0; r < materials.count(); r++) {
            textured |= ends[r + 1] > ends[r] && materials.isTextured(materials.ranked(r));
        }
        boolean texels = old.texelRed != null || added != null && added.texelRed != null;
        HitRows room = new HitRows(source.length, textured && texels, clear > 0, old.code != null, old.owner != null);
        room.count = source.length;
        room.reflective = reflective;
        room.clear = clear;
        for (int r = 0; r < materials.count(); r++) {
            if (ends[r + 1] > ends[r]) {
                room.addRun(materials.ranked(r), ends[r + 1]);
            }
        }
        return room;
    }

    private static int[] ends(int[] source) {
        int[] end = new int[source.length];
        for (int i = source.length - 1; i >= 0; i--) {
            // Numbers of added rows count backwards: ~0, ~1, ….
            boolean follows = i + 1 < source.length && source[i + 1] == (source[i] < 0 ? source[i] - 1 : source[i] + 1)
                    && source[i] < 0 == source[i + 1] < 0;
            end[i] = follows ? end[i + 1] : i + 1;
        }
        return end;
    }

    private static int[] materials(HitRows rows) {
        int[] materials = new int[rows.count];
        for (int r = 0; r < rows.runs; r++) {
            Arrays.fill(materials, rows.runStart(r), rows.runEnd[r], rows.runMaterial[r]);
        }
        return materials;
    }

    /** The same rows in the order that other materials ask for. */
    public static RowSplice sorted(HitRows old, MaterialTable materials) {
        int[] all = new int[old.count];
        Arrays.setAll(all, i -> i);
        var splice = new RowSplice(old, null, all, materials);
        splice.copy(old.parent);
        return splice;
    }

    /**
     * The rows that are seen from rows of the level above by rays that go on in one way.
     *
     * @param above what became of that level's rows; null if all of them are what they were
     * @param rays  from how many rows of that level they go on now
     * @param added rows traced from some of them; null for none
     */
    public static RowSplice seenFrom(RowSplice above, int rays, HitRows old, HitRows added, MaterialTable materials) {
        int[] hit = new int[rays];
        Arrays.fill(hit, Integer.MIN_VALUE);
        short[] parents = new short[HitRows.padded(old.count)];
        for (int i = 0; i < old.count; i++) {
            int parent = above == null ? old.parent[i] : above.now[old.parent[i]];
            parents[i] = (short) parent;
            if (parent >= 0 && parent < rays) {
                hit[parent] = i;
            }
        }
        for (int i = 0; added != null && i < added.count; i++) {
            hit[added.parent[i]] = ~i;
        }
        var splice = new RowSplice(old, added, Arrays.stream(hit).filter(s -> s != Integer.MIN_VALUE).toArray(), materials);
        splice.copy(parents);
        return splice;
    }

    private void copy(short[] oldParents) {
        HitRows from = old.seenFrom(oldParents, reflective);
        if (keepsRows()) {
            rows = from;
        } else {
            fill(rows.columns(), from.columns(), added == null ? null : added.columns());
        }
    }

    /** The rows as they are now. */
    public HitRows rows() {
        return rows;
    }

    /** The old rows that are left, with all rows added since, as one step. */
    public RowSplice then(RowSplice next) {
        return new RowSplice(this, next);
    }

    private RowSplice(RowSplice first, RowSplice second) {
        old = first.old;
        added = second.added;
        reflective = second.reflective;
        clear = second.clear;
        rows = second.rows;
        source = new int[second.source.length];
        Arrays.setAll(source, i -> second.source[i] < 0 ? second.source[i] : first.source[second.source[i]]);
        end = ends(source);
        now = new int[first.now.length];
        Arrays.setAll(now, i -> first.now[i] < 0 ? -1 : second.now[first.now[i]]);
    }

    /** The rows whose ray that goes on in some way is not known, because they are new or cast none before. */
    public int[] unfollowed(Bounce bounce) {
        int[] found = new int[bounce.rows(rows)];
        int count = 0;
        for (int i = 0; i < found.length; i++) {
            if (source[i] < 0 || source[i] >= bounce.rows(old)) {
                found[count++] = i;
            }
        }
        return Arrays.copyOf(found, count);
    }

    /**
     * Fills columns over the rows as they are now.
     *
     * @param columns where a column is missing below, its rows stay what they are
     * @param ofOld   columns over the old rows
     * @param ofAdded columns over the added ones; unread where there are none
     */
    public <C extends Enum<C> & ColumnKind> void fill(ColumnSet<C> columns, ColumnSet<C> ofOld, ColumnSet<C> ofAdded) {
        for (int i = 0; i < source.length; i = end[i]) {
            if (source[i] < 0) {
                columns.copy(ofAdded, ~source[i], i, end[i] - i);
            } else {
                columns.copy(ofOld, source[i], i, end[i] - i);
            }
        }
    }
}
