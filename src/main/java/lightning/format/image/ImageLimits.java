package lightning.format.image;

import java.io.IOException;

/** How large a picture file may be, so that a header of a few bytes cannot ask for all memory. */
final class ImageLimits {

    /** The largest width and height, pixels. */
    static final int MAX_SIDE = 16384;

    /** The largest number of pixels, 67 million; a film takes 12 bytes for each. */
    static final int MAX_PIXELS = 1 << 26;

    private ImageLimits() {}

    /** @throws IOException if a picture of this size is not read; the message says what would be */
    static void check(long width, long height) throws IOException {
        if (width < 1 || height < 1 || width > MAX_SIDE || height > MAX_SIDE || width * height > MAX_PIXELS) {
            throw new IOException("has " + width + " × " + height + " pixels; expected 1 to " + MAX_SIDE
                    + " in each direction and at most " + MAX_PIXELS + " in all");
        }
    }
}
