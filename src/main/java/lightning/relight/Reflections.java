package lightning.relight;

/** When an edit reaches the mirror images. */
public enum Reflections {
    /** On demand: mirror images keep showing the scene of their last update (paper §4.8). */
    STALE,
    /** With every edit. */
    CURRENT
}
