package lightning.render.relight.paper;

/** Update mode of mirror images after an edit. */
public enum ReflectionMode {
    /** On demand, as in 1998: mirror images keep showing the scene of their last update (paper §4.8). */
    STALE,
    /** With every edit: the default. */
    CURRENT
}
