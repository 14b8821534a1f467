package lightning.render.shading.layer;

import org.jspecify.annotations.Nullable;

/** Layer of one light over the hit rows of one tile and level: terms, or finished contributions. */
public sealed interface LightLayer permits LightRows, WeightedLayer {
    /** Returns the state and shadow ray result of each row; see {@link LightRows}. */
    byte[] states();

    /** Returns for each row the set of visible light samples; see {@link LightRows#visibleSamples}. */
    short @Nullable [][] visibleSamples();

    /** Returns whether the light reaches no row of the tile, so that none was tested. */
    boolean isUnreached();

    /** Returns the tints of unblocked shadow rays: red, green and blue columns; null if all are 1. */
    float @Nullable [][] tint();

    /** Returns whether a layer lights any row. @param layer null for a light without */
    static boolean isLit(@Nullable LightLayer layer) {
        return layer != null && layer.litCount() > 0;
    }

    /** Returns the number of lit rows. */
    int litCount();

    /** Returns the bytes of the columns, without array headers. */
    long bytes();

    /** Returns the bytes of the columns that are not shared with {@code before}. */
    long newBytes(@Nullable LightLayer before);

    /** Returns the bytes that compositing reads. */
    long bytesReadByCompositing();

    /** Returns the bytes per row that an update from {@code before} must read. */
    long rowBytesRead(@Nullable LightLayer before);
}
