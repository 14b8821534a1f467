package lightning.shot;

/** State of a frame. */
public enum FrameState {
    /** No film yet. */
    MISSING,
    /** Film of an older revision. */
    STALE,
    /** Film of the newest revision. */
    CURRENT,
    /** The newest revision failed; an older film may still be shown. */
    FAILED
}
