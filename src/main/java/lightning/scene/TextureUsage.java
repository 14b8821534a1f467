package lightning.scene;

/** What the samples of a picture's file stand for. */
public enum TextureUsage {
    /** Colors, which are made linear. */
    COLOR,
    /** Numbers, which no curve bends. */
    DATA,
    /** How much is there: the alpha of a picture that has it, else the luminance of its samples as they are. */
    OPACITY
}
