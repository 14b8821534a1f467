package lightning.scene.shot;

/**
 * Value of an attribute at one frame.
 *
 * @param frame         0 … {@link Shot#MAX_FRAME}
 * @param interpolation interpolation to the next keyframe
 */
public record Keyframe(int frame, KeyframeValue value, Interpolation interpolation) {
    public Keyframe {
        Shot.checkFrame("the frame of a key", frame);
    }
}
