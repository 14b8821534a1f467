package lightning.render.relight.plan;

/** When an edit reaches the mirror images. */
public enum ReflectionMode {
    /** As in 1998, on demand: mirror images keep showing the scene of their last update (paper §4.8). */
    STALE,
    /** With every edit: the default. */
    CURRENT
}
