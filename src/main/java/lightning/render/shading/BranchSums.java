package lightning.render.shading;

/**
 * For one light of one tile, the sums of the branches beside its way to the root of the tree: all that
 * composing needs of the other lights. While that light alone is edited, each frame adds these few
 * sums instead of all lights, with the same bits. Where no light is edited it is the sum of all of them.
 */
public final class BranchSums {
    /**
     * The edit that sums belong to: from one update to the next, as long as only this light changes. Keys
     * are told apart by identity: sums made under another key are void.
     */
    public static final class Key {
        /** Stands for the place of a light where none is edited. */
        public static final int NO_LIGHT = -1;

        private final int light;

        /** @param light the light's place in the scene, or {@link #NO_LIGHT} */
        public Key(int light) {
            this.light = light;
        }

        public int light() {
            return light;
        }
    }

    private final Key key;
    private final SumColumns[] leafToRoot;

    BranchSums(Key key, SumColumns[] fromLeaf) {
        this.key = key;
        this.leafToRoot = fromLeaf;
    }

    public Key key() {
        return key;
    }

    /** The sums, from the leaf to the root; null where a branch adds nothing. */
    SumColumns[] fromLeaf() {
        return leafToRoot;
    }

    /** The bytes of all sums, array headers left out: 12 to 36 for each row and branch. */
    public long bytes() {
        long bytes = 0;
        for (SumColumns sum : leafToRoot) {
            bytes += sum == null ? 0 : sum.bytes();
        }
        return bytes;
    }
}
