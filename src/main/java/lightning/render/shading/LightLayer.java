package lightning.render.shading;

/** One light's layer over the hit rows of one tile and level: terms, or finished contributions. */
public sealed interface LightLayer permits LightRows, WeightedLayer {
    /** State and way of each row, see {@link LightRows}. */
    byte[] states();

    /** To which samples of a light each row's ways are free, see {@link LightRows#visibleSamples}. */
    short[][] visibleSamples();

    /** What passes of the light on free ways: red, green and blue columns; null where it is 1 on all. */
    float[][] tint();

    /** How many rows are lit. */
    int litCount();

    /** The bytes that the columns hold, array headers left out. */
    long bytes();

    /** The bytes of those columns that are not also {@code before}'s, which may be null. */
    long newBytes(LightLayer before);

    /** The bytes that composing reads. */
    long bytesReadByCompositing();

    /** The bytes that must be read of each row to get here from {@code before}, which may be null. */
    long rowBytesRead(LightLayer before);
}
