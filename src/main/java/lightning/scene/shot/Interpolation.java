package lightning.scene.shot;

/** Interpolation from one keyframe to the next. */
public enum Interpolation {
    /** Linear; a direction rotates uniformly on the shorter arc. */
    LINEAR,
    /** Smooth, with a continuous slope and without overshoot beyond the neighboring keyframes. */
    SMOOTH,
    /** Constant until the next keyframe. */
    STEPPED
}
