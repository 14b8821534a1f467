package lightning.scene.attribute;

/** Behavior of an attribute's values between two keyframes. */
public enum KeyframeSupport {
    /** Numbers, which can be interpolated. */
    INTERPOLATED,
    /** Words and whole numbers, which hold until the next keyframe. */
    STEPPED,
    /** Names, links and files, which cannot be animated. */
    NONE
}
