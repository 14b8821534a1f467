package lightning.scene.shot;

/**
 * What something is at one frame.
 *
 * @param frame   0 … {@link Shot#MAX_FRAME}
 * @param interpolation how it goes on to the next key
 */
public record Keyframe(int frame, KeyframeValue value, Interpolation interpolation) {
    public Keyframe {
        Shot.checkFrame("the frame of a key", frame);
    }
}
