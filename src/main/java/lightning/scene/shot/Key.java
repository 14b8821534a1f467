package lightning.scene.shot;

/**
 * What something is at one frame.
 *
 * @param frame   0 … {@link Shot#MAX_FRAME}
 * @param passage how it goes on to the next key
 */
public record Key(int frame, Setting setting, Passage passage) {
    public Key {
        Shot.checkFrame("the frame of a key", frame);
    }
}
