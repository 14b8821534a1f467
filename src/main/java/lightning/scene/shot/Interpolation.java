package lightning.scene.shot;

/** How a value goes from one key to the next. */
public enum Interpolation {
    /** Evenly; a direction turns evenly on the shorter arc. */
    LINEAR,
    /** Without a corner: the slope is continuous, and nothing goes beyond what two neighboring keys say. */
    SMOOTH,
    /** Not at all: it stays until the next key. */
    STEPPED
}
