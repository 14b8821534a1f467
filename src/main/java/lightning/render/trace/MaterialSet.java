package lightning.render.trace;

import java.util.BitSet;
import java.util.function.IntPredicate;

/** A set of materials, told by their indices in a {@link MaterialTable}. Immutable. */
public final class MaterialSet {
    public static final MaterialSet NONE = new MaterialSet(new BitSet());

    private final BitSet members;

    private MaterialSet(BitSet members) {
        this.members = members;
    }

    /** Those of materials {@code 0 … count − 1} that a condition holds for. */
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

    /** Whether any of the rows is of one of these materials. */
    public boolean intersects(HitRows rows) {
        return countIn(rows) > 0;
    }

    /** How many of the rows are of these materials. */
    public int countIn(HitRows rows) {
        if (isEmpty()) {
            // Without a look at the rows: an update of lights asks this for every tile.
            return 0;
        }
        int count = 0;
        for (int r = 0; r < rows.runCount; r++) {
            count += contains(rows.runMaterial[r]) ? rows.runEnd[r] - rows.runStart(r) : 0;
        }
        return count;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof MaterialSet s && members.equals(s.members);
    }

    @Override
    public int hashCode() {
        return members.hashCode();
    }

    @Override
    public String toString() {
        return members.toString();
    }
}
