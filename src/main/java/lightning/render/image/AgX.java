package lightning.render.image;

/**
 * AgX view transform (Sobotka, github.com/sobotka/AgX, 2022): compresses colors toward gray, applies a curve to the logarithm of each
 * channel, and expands the colors again. Bright colors become white without a change of hue.
 *
 * <ul>
 * <li>Inset: the chromaticity of each sRGB primary moves 20 % toward the white point (Sobotka's compression of 0.2). A color c becomes
 * {@code 0.8 · c + 0.2 · g}, where the gray g is the mean of the channels weighted by the primaries' sums X + Y + Z. This is the published
 * matrix, with exact grays. The outset is its inverse, applied to the encoded channels (Wrensch, Minimal AgX Implementation,
 * iolite-engine.com, 2023), so that a color that the curve leaves unchanged stays unchanged.
 * <li>Logarithm: −10 to +6.5 stops around middle gray 0.18, which is −12.47393 to 4.026069 around 1, become 0 to 1.
 * <li>Curve: Smith's sigmoid with the published pivot (10 / 16.5, 0.5), slope 2, and powers 3 below and 3.25 above the pivot
 * (github.com/sobotka/SB2383-Configuration-Generation, 2023). It is the formula, not a fit. Its value is a display value: middle gray
 * is shown at 0.5.
 * </ul>
 */
final class AgX {
    /** Smallest and largest stops around middle gray. */
    private static final double MIN_STOPS = -10;
    private static final double MAX_STOPS = 6.5;
    private static final Log2Shaper LOG = new Log2Shaper(MIN_STOPS, MAX_STOPS);
    /** Linear gray from which on the curve is white, 2^4.026069. */
    static final double WHITE = Log2Shaper.MIDDLE_GRAY * StrictMath.pow(2, MAX_STOPS);

    private static final double INSET = 0.2;
    /** X + Y + Z of each primary of sRGB (IEC 61966-2-1, columns of the matrix to XYZ), divided by that of white. */
    private static final double RED_SHARE;
    private static final double GREEN_SHARE;
    private static final double BLUE_SHARE;

    static {
        double red = 0.4124 + 0.2126 + 0.0193;
        double green = 0.3576 + 0.7152 + 0.1192;
        double blue = 0.1805 + 0.0722 + 0.9505;
        double white = red + green + blue;
        RED_SHARE = red / white;
        GREEN_SHARE = green / white;
        BLUE_SHARE = blue / white;
    }

    private static final double PIVOT_X = MIN_STOPS / (MIN_STOPS - MAX_STOPS);
    private static final double PIVOT_Y = 0.5;
    private static final double SLOPE = 2;
    private static final double TOE_POWER = 3;
    private static final double SHOULDER_POWER = 3.25;
    private static final double TOE_SCALE = scale(PIVOT_X, PIVOT_Y, TOE_POWER);
    private static final double SHOULDER_SCALE = scale(1 - PIVOT_X, 1 - PIVOT_Y, SHOULDER_POWER);

    private AgX() {}

    /** Returns the display value, 0 to 1, of a linear gray ≥ 0. */
    static double gray(double v) {
        return sigmoid(LOG.encode(v));
    }

    /** Returns the gray of a color whose distance to it the inset shrinks. */
    static double center(double red, double green, double blue) {
        return RED_SHARE * red + GREEN_SHARE * green + BLUE_SHARE * blue;
    }

    /** Returns a channel, moved toward the color's {@link #center}. */
    static double inset(double v, double center) {
        // Also exact if both are equal.
        return v + INSET * (center - v);
    }

    /** Returns a channel that {@link #inset} would move to {@code v}. */
    static double outset(double v, double center) {
        return v + INSET / (1 - INSET) * (v - center);
    }

    /** Returns the curve: 0 at 0, 1 at 1, with {@link #SLOPE} at the pivot. */
    private static double sigmoid(double x) {
        return x < PIVOT_X ? PIVOT_Y - rise(PIVOT_X - x, TOE_SCALE, TOE_POWER)
                : PIVOT_Y + rise(x - PIVOT_X, SHOULDER_SCALE, SHOULDER_POWER);
    }

    /** Returns the distance from the pivot's value at a distance from the pivot; straight at first, then less and less steep. */
    private static double rise(double distance, double scale, double power) {
        double t = SLOPE * distance / scale;
        return scale * t / StrictMath.pow(1 + StrictMath.pow(t, power), 1 / power);
    }

    /** Returns the scale for which {@link #rise} is {@code height} at {@code width}. */
    private static double scale(double width, double height, double power) {
        double straight = SLOPE * width;
        return straight / StrictMath.pow(StrictMath.pow(straight / height, power) - 1, 1 / power);
    }
}
