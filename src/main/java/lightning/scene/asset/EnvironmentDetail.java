package lightning.scene.asset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.file.ContentDigest;

/**
 * All pixels of a large environment image, for views of it. Its light is computed from a smaller map.
 *
 * <p>A pixel takes 4 bytes: three values of 8 bits with a common exponent of 8 (Ward, Real Pixels, Graphics Gems II, 1991), so pixels of Radiance
 * images keep their values. Coarser levels are means of 2×2, 4×4, … pixels; a picture uses the one whose pixels are about as large as its own.
 * Immutable after {@link #freeze}.
 */
public final class EnvironmentDetail {
    private static final int EXPONENT_BIAS = 128;
    private static final int MANTISSA_BITS = 8;
    private static final int MAX_MANTISSA = (1 << MANTISSA_BITS) - 1;
    /** Bytes of the pixels and of all coarser levels, for each pixel of the image. */
    private static final double BYTES_PER_PIXEL = 4 * 4 / 3.0;

    private final List<Level> levels = new ArrayList<>();
    private final int smallest;

    /** @param rgbe {@code int[width * height]}, row by row from the top */
    private record Level(int width, int height, int[] rgbe) {
        Level(int width, int height) {
            this(width, height, new int[width * height]);
        }

        double channel(int x, int y, int channel) {
            return decode(rgbe[y * width + x], channel);
        }
    }

    /**
     * @param width    of the image, pixels
     * @param height   of the image, pixels
     * @param smallest number of pixels of the map of its light: no level has fewer
     */
    public EnvironmentDetail(int width, int height, int smallest) {
        levels.add(new Level(width, height));
        this.smallest = smallest;
    }

    /** Returns the memory of an image in bytes. */
    public static long bytes(long pixels) {
        return (long) (BYTES_PER_PIXEL * pixels);
    }

    /** Returns its memory in bytes. */
    long bytes() {
        return bytes((long) levels.getFirst().width * levels.getFirst().height);
    }

    /**
     * Sets a pixel.
     *
     * @param rgb linear, each 0 … {@link lightning.scene.value.SceneLimits#MAX_EMISSION}
     */
    public void set(int x, int y, float[] rgb) {
        Level full = levels.getFirst();
        full.rgbe[y * full.width + x] = encode(rgb[0], rgb[1], rgb[2]);
    }

    /** Computes the coarser levels, after all pixels are set. */
    public void freeze() {
        for (Level last = levels.getLast(); last.rgbe.length / 4 > smallest; last = levels.getLast()) {
            levels.add(half(last));
        }
    }

    private static Level half(Level from) {
        Level to = new Level(Math.ceilDiv(from.width, 2), Math.ceilDiv(from.height, 2));
        float[] mean = new float[3];
        for (int y = 0; y < to.height; y++) {
            int below = Math.min(2 * y + 1, from.height - 1);
            for (int x = 0; x < to.width; x++) {
                int right = Math.min(2 * x + 1, from.width - 1);
                for (int c = 0; c < 3; c++) {
                    mean[c] = (float) ((from.channel(2 * x, 2 * y, c) + from.channel(right, 2 * y, c) + from.channel(2 * x, below, c)
                            + from.channel(right, below, c)) / 4);
                }
                to.rgbe[y * to.width + x] = encode(mean[0], mean[1], mean[2]);
            }
        }
        return to;
    }

    /**
     * Returns the level whose pixels are closest in size to those of a picture; −1 if all are finer, so the map of the light is closest.
     *
     * @param pixelAngle width of a pixel of the picture, radians, &gt; 0
     */
    int level(double pixelAngle) {
        double wanted = 2 * Math.PI / pixelAngle * Math.sqrt(2);
        for (int i = 0; i < levels.size(); i++) {
            if (levels.get(i).width <= wanted) {
                return i;
            }
        }
        return -1;
    }

    int width(int level) {
        return levels.get(level).width;
    }

    int height(int level) {
        return levels.get(level).height;
    }

    /** Returns one channel (0 red, 1 green, 2 blue) of a pixel of a level. */
    double channel(int level, int x, int y, int channel) {
        return levels.get(level).channel(x, y, channel);
    }

    /** Returns three mantissas from the lowest byte up, and above them the exponent; the largest mantissa is 128 … 255. */
    static int encode(float red, float green, float blue) {
        float max = Math.max(red, Math.max(green, blue));
        int exponent = Math.getExponent(max) + 1;
        if (mantissa(max, power(MANTISSA_BITS - exponent)) > MAX_MANTISSA) {
            exponent++;
        }
        int stored = exponent + EXPONENT_BIAS;
        if (stored < 1) {
            return 0;
        }
        double scale = power(MANTISSA_BITS - exponent);
        return mantissa(red, scale) | mantissa(green, scale) << MANTISSA_BITS | mantissa(blue, scale) << 2 * MANTISSA_BITS
                | stored << 3 * MANTISSA_BITS;
    }

    private static int mantissa(float value, double scale) {
        return (int) (value * scale + 0.5);
    }

    /** Returns 2^exponent by its bits, much faster than a function of the library. */
    private static double power(int exponent) {
        return Double.longBitsToDouble((long) (exponent + Double.MAX_EXPONENT) << 52);
    }

    /** Returns a channel of an encoded color. */
    static double decode(int rgbe, int channel) {
        int mantissa = rgbe >>> channel * MANTISSA_BITS & MAX_MANTISSA;
        return mantissa * power((rgbe >>> 3 * MANTISSA_BITS) - EXPONENT_BIAS - MANTISSA_BITS);
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof EnvironmentDetail d && levels.getFirst().width == d.levels.getFirst().width
                && Arrays.equals(levels.getFirst().rgbe, d.levels.getFirst().rgbe);
    }

    /** Adds all numbers that determine it. */
    void addTo(ContentDigest digest) {
        digest.add(levels.getFirst().width);
        digest.add(levels.getFirst().rgbe);
        digest.add(levels.size());
    }

    @Override
    public int hashCode() {
        return Integer.hashCode(levels.getFirst().rgbe.length);
    }
}
