package lightning.render.image;

/**
 * False-color image of the differences between two films.
 *
 * <p>Black pixels agree in every bit. Every other pixel shows the largest absolute linear difference of its channels on a
 * logarithmic scale: dark violet up to 2⁻²⁴ (the last bit of a value just below 1), orange at about 2⁻⁸ (one step of an 8-bit
 * display), pale yellow from 1 upwards and for non-finite values. A single differing bit is visible. Lightness increases along the
 * scale, so the order is clear without a legend and without color vision.
 */
public final class DifferenceImage {

    /** Position on the scale, 0…1, where differences begin: the darkest color that is distinct from black. */
    private static final double MIN_SHARE = 0.25;

    /** log2 of the largest difference that counts as negligible. */
    private static final double MIN_LOG2 = -24;

    /** Equidistant display colors from black through violet, red and orange to pale yellow. */
    private static final int[] SCALE = {
        0x000000, 0x1F0C48, 0x550F6D, 0x88226A, 0xBA3655, 0xE35933, 0xF98C0A, 0xF9C932, 0xFCFFA4
    };

    private DifferenceImage() {}

    /**
     * Returns the image, for {@link ViewTransform#DEFAULT}.
     *
     * @throws IllegalArgumentException if the sizes of the films differ
     */
    public static Film of(Film a, Film b) {
        Difference.requireSameSize(a, b);
        Film picture = Film.black(a.width(), a.height());
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                if (differs(a, b, x, y)) {
                    DisplayPixels.set(picture, x, y, color(scalePosition(largest(a, b, x, y))));
                }
            }
        }
        return picture;
    }

    /** Returns the display color 0xRRGGBB at a position 0…1 of the scale. */
    static int color(double share) {
        double at = share * (SCALE.length - 1);
        int i = Math.min((int) at, SCALE.length - 2);
        double t = at - i;
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            int from = SCALE[i] >> shift & 0xFF;
            int to = SCALE[i + 1] >> shift & 0xFF;
            rgb |= (int) Math.round(from + t * (to - from)) << shift;
        }
        return rgb;
    }

    /** Returns the position on the scale, {@link #MIN_SHARE} to 1, of an absolute linear difference ≥ 0. */
    static double scalePosition(double difference) {
        double log2 = Math.log(difference) / Math.log(2);
        return MIN_SHARE + (1 - MIN_SHARE) * Math.clamp((log2 - MIN_LOG2) / -MIN_LOG2, 0, 1);
    }

    private static double largest(Film a, Film b, int x, int y) {
        return Math.max(Difference.absolute(a.red(x, y), b.red(x, y)),
                Math.max(Difference.absolute(a.green(x, y), b.green(x, y)),
                        Difference.absolute(a.blue(x, y), b.blue(x, y))));
    }

    private static boolean differs(Film a, Film b, int x, int y) {
        return Float.floatToRawIntBits(a.red(x, y)) != Float.floatToRawIntBits(b.red(x, y))
                || Float.floatToRawIntBits(a.green(x, y)) != Float.floatToRawIntBits(b.green(x, y))
                || Float.floatToRawIntBits(a.blue(x, y)) != Float.floatToRawIntBits(b.blue(x, y));
    }
}
