package lightning.format.exr;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/**
 * Display window of a picture: what it shows. Its data may cover only a part of it, and reach beyond.
 *
 * @param left   first column of the data, in columns of the window; negative beyond it
 * @param top    first line of the data, in lines of the window
 * @param width  width of the window
 * @param height height of the window
 */
public record ExrWindow(int left, int top, int width, int height) {
    /** Maximum pixels of a window for each of its data, above {@link #ANY_PIXELS}. */
    private static final int MAX_RATIO = 256;
    /** Number of pixels that the window of any data may have. */
    private static final long ANY_PIXELS = 1 << 20;

    /**
     * Returns the window of data; the data alone if the window is absent, or has no pixels.
     *
     * @param data    data window: first column and line, last column and line; not empty
     * @param display display window
     * @throws IOException if the window is much larger than the data
     */
    static ExrWindow of(int[] data, int @Nullable [] display) throws IOException {
        long dataWidth = (long) data[2] - data[0] + 1;
        long dataHeight = (long) data[3] - data[1] + 1;
        if (display == null || display[2] < display[0] || display[3] < display[1]) {
            return new ExrWindow(0, 0, (int) dataWidth, (int) dataHeight);
        }
        long width = (long) display[2] - display[0] + 1;
        long height = (long) display[3] - display[1] + 1;
        long left = (long) data[0] - display[0];
        long top = (long) data[1] - display[1];
        if (width > Integer.MAX_VALUE || height > Integer.MAX_VALUE || Math.abs(left) > Integer.MAX_VALUE
                || Math.abs(top) > Integer.MAX_VALUE
                || Math.multiplyHigh(width, height) != 0 || width * height > Math.max(ANY_PIXELS, MAX_RATIO * dataWidth * dataHeight)) {
            throw new IOException("has a display window of " + width + "×" + height + " pixels for data of " + dataWidth + "×" + dataHeight
                    + "; expected at most " + MAX_RATIO + " times as many");
        }
        return new ExrWindow((int) left, (int) top, (int) width, (int) height);
    }
}
