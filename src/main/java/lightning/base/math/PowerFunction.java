package lightning.base.math;

/**
 * The program's only power function: x<sup>n</sup> for x in 0…1 and n ≥ 0, accurate to far below half a unit of a float's last place.
 *
 * <p>Computes 2<sup>n·log₂x</sup> with additions, multiplications, one division and bit patterns only. A vector version that repeats the
 * same operations therefore gives the same bits, which {@link Math#pow} does not promise. The logarithm is the series of
 * 2·artanh((m−1)/(m+1)) over m in √½…√2; the exponential is Taylor's over −½…½.
 */
public final class PowerFunction {
    /** The bits of √2's mantissa: above it the mantissa is halved. */
    public static final long SQRT2_MANTISSA = 0x6A09E667F3BCDL;

    public static final long MANTISSA = 0xFFFFFFFFFFFFFL;
    public static final long ONE = 0x3FF0000000000000L;
    public static final long HALF = 0x3FE0000000000000L;
    public static final double LOG2_E_TWICE = 2 * 1.4426950408889634;
    public static final double LN2 = 0.6931471805599453;
    /** Below this exponent the power rounds to 0 in float, with room to spare. */
    public static final double MIN_EXPONENT = -1000;
    /** Adding and subtracting it rounds a small double to an integer. */
    public static final double ROUND = 0x1.8p52;

    private PowerFunction() {}

    /**
     * x<sup>n</sup>, where 0<sup>0</sup> = 1.
     *
     * @param x 0…1; below the smallest normal double it counts as 0
     * @param n ≥ 0
     */
    public static double pow(double x, double n) {
        return powOfLog2(log2(x), n);
    }

    /**
     * Returns log₂x for {@link #powOfLog2}.
     *
     * @param x 0…1; below the smallest normal double it counts as 0
     * @return at most 0; −∞ for 0
     */
    public static double log2(double x) {
        if (!(x >= Double.MIN_NORMAL)) {
            return Double.NEGATIVE_INFINITY;
        }
        long bits = Double.doubleToRawLongBits(x);
        long mantissa = bits & MANTISSA;
        boolean upper = mantissa > SQRT2_MANTISSA;
        double exponent = (double) ((bits >>> 52) - (upper ? 1022 : 1023));
        double m = Double.longBitsToDouble(mantissa | (upper ? HALF : ONE));
        double f = m - 1;
        double s = f / (m + 1);
        double z = s * s;
        double series = 1.0 / 19;
        series = series * z + 1.0 / 17;
        series = series * z + 1.0 / 15;
        series = series * z + 1.0 / 13;
        series = series * z + 1.0 / 11;
        series = series * z + 1.0 / 9;
        series = series * z + 1.0 / 7;
        series = series * z + 1.0 / 5;
        series = series * z + 1.0 / 3;
        series = series * z + 1.0;
        return exponent + s * LOG2_E_TWICE * series;
    }

    /**
     * Returns x<sup>n</sup> from log₂x, with the bits of {@link #pow}.
     *
     * @param log2 as {@link #log2} returns it
     * @param n    ≥ 0
     */
    public static double powOfLog2(double log2, double n) {
        if (log2 == Double.NEGATIVE_INFINITY) {
            return n == 0 ? 1 : 0;
        }
        return exponential(n * log2);
    }

    /**
     * Returns 2<sup>exponent</sup>, 0 for −∞.
     *
     * @param exponent at most 0
     */
    public static double exponential(double exponent) {
        if (exponent == Double.NEGATIVE_INFINITY) {
            return 0;
        }
        double p = exponent;
        p = p < MIN_EXPONENT ? MIN_EXPONENT : p;
        double integer = (p + ROUND) - ROUND;
        double y = (p - integer) * LN2;
        double e = 1.0 / 479001600;
        e = e * y + 1.0 / 39916800;
        e = e * y + 1.0 / 3628800;
        e = e * y + 1.0 / 362880;
        e = e * y + 1.0 / 40320;
        e = e * y + 1.0 / 5040;
        e = e * y + 1.0 / 720;
        e = e * y + 1.0 / 120;
        e = e * y + 1.0 / 24;
        e = e * y + 1.0 / 6;
        e = e * y + 0.5;
        e = e * y + 1;
        e = e * y + 1;
        double scale = Double.longBitsToDouble((long) (integer + 1023) << 52);
        return e * scale;
    }
}
