package lightning.scene.light;

/** Region of a light filter. */
public enum FilterShape {
    /** Nowhere. */
    NONE,
    /** On points in a box. */
    BOX,
    /** On points in an ellipsoid that just fits into the box. */
    SPHERE,
    /** Everywhere, along the y axis of the box: not at all from its top on, fully from its bottom on. */
    RAMP
}
