package lightning.render.relight.tile;

/** What is kept of the mirror levels. */
public enum MirrorStorage {
    /** Rows and layers like those of the first level: an edit of a light is as cheap there. */
    FULL_ROWS,
    /** The paper's list of hit shapes: small; points and lights are computed anew, without a search. */
    HIT_SHAPES;

    /** The one that takes least memory. */
    public static final MirrorStorage SMALLEST = HIT_SHAPES;

    /** Whether rows and layers are kept. */
    public boolean storesRows() {
        return this == FULL_ROWS;
    }
}
