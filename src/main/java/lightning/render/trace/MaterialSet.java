package lightning.render.trace;

import java.util.BitSet;
import java.util.function.IntPredicate;

/** Immutable set of materials, identified by their indices in a {@link MaterialTable}. */
public record MaterialSet(BitSet members) {
    public static final MaterialSet NONE = new MaterialSet(new BitSet());

    /** Returns the materials among {@code 0 … count − 1} that satisfy a condition. */
    public static MaterialSet of(int count, IntPredicate condition) {
        BitSet members = new BitSet(count);
        for (int m = 0; m < count; m++) {
            members.set(m, condition.test(m));
        }
        return members.isEmpty() ? NONE : new MaterialSet(members);
    }

    public boolean contains(int material) {
        return members.get(material);
    }

    public boolean isEmpty() {
        return members.isEmpty();
    }

    /** Returns whether any of the rows has one of these materials. */
    public boolean intersects(HitRows rows) {
        return countIn(rows) > 0;
    }

    /** Returns the number of rows with one of these materials. */
    public int countIn(HitRows rows) {
        if (isEmpty()) {
            // Returns without scanning the rows: an update of lights calls this for every tile.
            return 0;
        }
        int count = 0;
        for (int r = 0; r < rows.runCount; r++) {
            count += contains(rows.runMaterial[r]) ? rows.runEnd[r] - rows.runStart(r) : 0;
        }
        return count;
    }
}
