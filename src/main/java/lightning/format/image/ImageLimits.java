package lightning.format.image;

import java.io.IOException;

/** Limits for the size of image files, so that a small header cannot request all memory. */
final class ImageLimits {

    /** Maximum width and height in pixels. */
    static final int MAX_SIDE = 16384;

    /** Maximum number of pixels, 67 million; a film takes 12 bytes for each. */
    static final int MAX_PIXELS = 1 << 26;

    private ImageLimits() {}

    /**
     * Checks an image size.
     *
     * @throws IOException if it exceeds the limits; the message contains them
     */
    static void check(long width, long height) throws IOException {
        if (width < 1 || height < 1 || width > MAX_SIDE || height > MAX_SIDE || width * height > MAX_PIXELS) {
            throw new IOException("has " + width + " × " + height + " pixels; expected 1 to " + MAX_SIDE
                    + " in each direction and at most " + MAX_PIXELS + " in total");
        }
    }
}
