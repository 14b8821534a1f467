package lightning.render.image;

/**
 * Difference of two films of the same size, measured on every visible pixel.
 *
 * <p>"Values" are the three channels of each pixel. Absolute errors, mean, RMSE and linear PSNR use linear values; the display
 * measures use the 8-bit codes of {@link ViewTransform#DEFAULT}. A value with the same bits in both films differs by 0, infinities
 * and NaNs included. A NaN and any other value differ by infinity.
 *
 * @param pixels       number of pixels with at least one value of different bits
 * @param values       number of values of different bits
 * @param maxUlp       largest distance of two values in units in the last place, which is the number of floats from one to the
 *                     other; 0 and −0 are 0 apart, NaNs lie beyond infinity
 * @param maxLevels    largest distance of two 8-bit codes, 0 to 255
 * @param maxAbsolute  largest absolute difference, linear, ≥ 0
 * @param meanAbsolute mean absolute difference over all values, linear, ≥ 0
 * @param rmse         square root of the mean squared difference over all values, linear, ≥ 0
 * @param linearPsnr   peak signal-to-noise ratio in dB, {@code 20·log10(1 / rmse)} for the peak 1; infinite if equal
 * @param displayPsnr  peak signal-to-noise ratio of 8-bit codes in dB, for the peak 255
 * @param ssim         structural similarity of the displayed luma, 1 if equal; see {@link Ssim}
 * @param x            column of the pixel with the largest absolute difference; if all are 0, of the first pixel with different
 *                     bits; −1 if all bits are equal
 * @param y            its row from the top, or −1
 */
public record Difference(
        long pixels,
        long values,
        long maxUlp,
        int maxLevels,
        double maxAbsolute,
        double meanAbsolute,
        double rmse,
        double linearPsnr,
        double displayPsnr,
        double ssim,
        int x,
        int y) {

    /**
     * Compares two films.
     *
     * @throws IllegalArgumentException if their sizes differ
     */
    public static Difference of(Film a, Film b) {
        requireSameSize(a, b);
        var sums = new Accumulator();
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                sums.addPixel(a, b, x, y);
            }
        }
        double count = 3.0 * a.width() * a.height();
        double rmse = Math.sqrt(sums.squares / count);
        return new Difference(sums.pixels, sums.values, sums.maxUlp, sums.maxLevels, Math.max(sums.maxAbsolute, 0),
                sums.absolute / count, rmse, psnr(1, rmse), psnr(255, Math.sqrt(sums.displaySquares / count)),
                Ssim.displayedLuma(a, b), sums.x, sums.y);
    }

    /** Returns whether every visible value has the same bits. */
    public boolean isNone() {
        return values == 0;
    }

    /** Returns the number of floats from {@code a} to {@code b}, ≥ 0: 1 for neighbors, 0 for 0 and −0. */
    static long ulps(float a, float b) {
        return Math.abs(orderIndex(a) - orderIndex(b));
    }

    /** Returns the absolute difference; 0 for the same bits, infinity for a NaN and any other value. */
    static double absolute(float a, float b) {
        if (Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b)) {
            return 0;
        }
        double difference = Math.abs((double) a - b);
        return Double.isNaN(difference) ? Double.POSITIVE_INFINITY : difference;
    }

    static void requireSameSize(Film a, Film b) {
        if (a.width() != b.width() || a.height() != b.height()) {
            throw new IllegalArgumentException("pictures to compare must have the same size; one has " + a.width() + " × "
                    + a.height() + " pixels, the other " + b.width() + " × " + b.height());
        }
    }

    /** Returns the rank of a float in the order of all floats, both zeros at 0. */
    private static long orderIndex(float value) {
        int bits = Float.floatToRawIntBits(value);
        return bits >= 0 ? bits : -(long) (bits & 0x7FFFFFFF);
    }

    private static double psnr(double peak, double rmse) {
        return 20 * Math.log10(peak / rmse);
    }

    private static final class Accumulator {
        long pixels;
        long values;
        long maxUlp;
        int maxLevels;
        double maxAbsolute = -1;
        double absolute;
        double squares;
        double displaySquares;
        int x = -1;
        int y = -1;

        void addPixel(Film a, Film b, int px, int py) {
            long before = values;
            double largest = Math.max(addValue(a.red(px, py), b.red(px, py)),
                    Math.max(addValue(a.green(px, py), b.green(px, py)), addValue(a.blue(px, py), b.blue(px, py))));
            if (values > before) {
                pixels++;
                if (largest > maxAbsolute) {
                    maxAbsolute = largest;
                    x = px;
                    y = py;
                }
            }
        }

        private double addValue(float a, float b) {
            if (Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b)) {
                return 0;
            }
            values++;
            maxUlp = Math.max(maxUlp, ulps(a, b));
            double difference = Difference.absolute(a, b);
            absolute += difference;
            squares += difference * difference;
            int levels = Math.abs(Srgb.encode(a) - Srgb.encode(b));
            maxLevels = Math.max(maxLevels, levels);
            displaySquares += (double) levels * levels;
            return difference;
        }
    }
}
