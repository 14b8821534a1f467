package lightning.scene.asset;

/** Meaning of the samples of an image file. */
public enum TextureUsage {
    /** Colors, which are converted to linear. */
    COLOR,
    /** Colors of a light's face, which may exceed 1. */
    EMISSION,
    /** Linear data, not converted. */
    DATA,
    /** Opacity: the alpha of an image that has it, else the luminance of its unconverted samples. */
    OPACITY
}
