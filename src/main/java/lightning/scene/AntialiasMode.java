package lightning.scene;

/** Pixels that receive several samples. */
public enum AntialiasMode {
    /** None: each pixel has one sample, at its center. */
    OFF,
    /** Pixels at an edge of a shape, shadow, texture, highlight or mirror image. */
    EDGES,
    /** All pixels. */
    EVERY
}
