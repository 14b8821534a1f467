package lightning.render.shading.composition;

import org.jspecify.annotations.Nullable;

/**
 * Partial sums of the light tree for one light of one tile: the sums of all branches next to the light's path to the root. While
 * only that light is edited, each frame adds these few sums instead of all lights, with the same bits. If no light is edited, it is
 * the sum of all lights.
 */
public final class BranchSums {
    /**
     * Identifies the run of updates during which only one light changes. Keys are compared by identity: sums with another key are
     * invalid.
     */
    public static final class Key {
        /** Light index if no light is edited. */
        public static final int NO_LIGHT = -1;

        private final int light;

        /** @param light the light's index in the scene, or {@link #NO_LIGHT} */
        public Key(int light) {
            this.light = light;
        }

        public int light() {
            return light;
        }
    }

    private final Key key;
    private final @Nullable SumColumns[] leafToRoot;

    BranchSums(Key key, @Nullable SumColumns[] fromLeaf) {
        this.key = key;
        this.leafToRoot = fromLeaf;
    }

    public Key key() {
        return key;
    }

    /** Returns the sums from the leaf to the root; null for a branch that adds nothing. */
    @Nullable
    SumColumns[] fromLeaf() {
        return leafToRoot;
    }

    /** Returns the bytes of all sums, without array headers: 12 to 36 for each row and branch. */
    public long bytes() {
        long bytes = 0;
        for (SumColumns sum : leafToRoot) {
            bytes += sum == null ? 0 : sum.bytes();
        }
        return bytes;
    }
}
