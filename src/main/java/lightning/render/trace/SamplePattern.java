package lightning.render.trace;

/**
 * Patterns that distribute the samples of area lights over the samples of a pixel. A pattern combines a <em>part</em> of the
 * light's samples, which differs between the samples of a pixel, and a <em>rotation</em> of all of them, which differs between
 * pixels. Together the samples of a pixel use every part once, so that few light samples of each give the pixel as many as a pixel
 * center has. A pattern is a function of pixel and sample alone, and mirrored and refracted rays inherit it.
 */
public final class SamplePattern {
    /** The largest number of patterns, which are stored in a byte. */
    public static final int MAX_PATTERNS = 256;
    private static final int MAX_ROTATIONS = 16;

    private SamplePattern() {}

    /** Returns the number of parts of a pixel with {@code grid}×{@code grid} samples. */
    public static int parts(int grid) {
        return grid * grid;
    }

    /** Returns the number of rotations, a power of two. */
    public static int rotations(int grid) {
        return Math.min(MAX_ROTATIONS, Integer.highestOneBit(MAX_PATTERNS / parts(grid)));
    }

    /**
     * Returns the pattern of a sample, as an unsigned byte.
     *
     * @param x    column of the pixel in the image
     * @param y    line of the pixel in the image
     * @param part part of the light's samples ({@link SampleCells#part})
     */
    public static byte of(int x, int y, int part, int grid) {
        int h = x * 0x9E3779B1 + y * 0x85EBCA77;
        h = (h ^ h >>> 15) * 0x2C1B3C6D;
        h = (h ^ h >>> 12) * 0x297A2D39;
        return (byte) (parts(grid) * ((h >>> 28) % rotations(grid)) + part);
    }
}
