package lightning.scene;

/** Which pixels are made of several samples. */
public enum AntialiasMode {
    /** None: a pixel is what its center shows. */
    OFF,
    /** Those where an edge of a shape, shadow, texture, highlight or mirror image passes. */
    EDGES,
    /** All. */
    EVERY
}
