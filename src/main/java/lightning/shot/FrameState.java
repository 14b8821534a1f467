package lightning.shot;

/** What there is of a frame. */
public enum FrameState {
    /** No film yet. */
    MISSING,
    /** A film of an older edit. */
    STALE,
    /** The film of the newest edit. */
    CURRENT,
    /** The newest edit could not be made here; what there was may still be shown. */
    FAILED
}
