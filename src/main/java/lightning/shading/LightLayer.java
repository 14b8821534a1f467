package lightning.shading;

/** One light's layer over the hit rows of one tile and level, in either form. */
public sealed interface LightLayer permits LightRows, RatioRows {
    /** State and way of each row, see {@link LightRows}. */
    byte[] states();

    /** How many rows are lit. */
    int lit();

    /** The bytes that the columns hold, array headers left out. */
    long bytes();
}
