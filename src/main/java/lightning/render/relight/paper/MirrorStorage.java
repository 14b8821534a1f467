package lightning.render.relight.paper;

/** Storage of the mirror levels. */
public enum MirrorStorage {
    /** Rows and layers like those of the first level: light edits are equally fast there. */
    FULL_ROWS,
    /** The paper's list of hit shapes: small; points and lights are recomputed without intersection tests. */
    HIT_SHAPES;

    /** Storage with the least memory. */
    public static final MirrorStorage SMALLEST = HIT_SHAPES;

    /** Returns whether rows and layers are stored. */
    public boolean storesRows() {
        return this == FULL_ROWS;
    }
}
