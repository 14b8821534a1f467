package lightning.image;

import java.util.Arrays;
import lightning.math.SrgbCurve;

/**
 * The sRGB encoding to and from 8 bits (IEC 61966-2-1), correctly rounded.
 *
 * <p>For a linear value v in 0…1 the code is {@code round(255 · s)}, where {@code s = 12.92 · v} up to v = 0.0031308 and
 * {@code s = 1.055 · v^(1/2.4) − 0.055} above. {@link #formula} is just that; {@link #encode} gives the same code for
 * every float from a table, without a power.
 */
final class Srgb {

    /** The bits of 2⁻¹³; below it every code is 0, as 12.92 · 255 · 2⁻¹³ = 0.40 rounds down. */
    private static final int LEAST_BITS = Float.floatToRawIntBits(0x1p-13f);

    private static final int WHITE_BITS = Float.floatToRawIntBits(1);

    private static final int INFINITY_BITS = Float.floatToRawIntBits(Float.POSITIVE_INFINITY);

    /** 256 buckets for each factor of two; a bucket then never holds more than one threshold (a test checks it). */
    private static final int BUCKET_SHIFT = 23 - 8;

    private static final int LOW_BITS = (1 << BUCKET_SHIFT) - 1;

    private static final int CODES = 0xFF;

    /** {@code THRESHOLD[c]} is the smallest float whose code is c; one more that is never reached. */
    static final float[] THRESHOLD = thresholds();

    /**
     * For each bucket of all floats, in the order of their bits taken as a number without a sign, the number which, added to the low
     * bits of a float, gives the code in the eight bits above: the code of the bucket's smallest float, and such a fraction
     * that the sum carries from the threshold onwards. Infinity shares its bucket with NaNs, whose sum carries to 256, as code 0.
     * Negative floats and other NaNs have 0. Half a megabyte, of which a picture touches some kilobytes.
     */
    private static final int[] ENTRY = entries();

    private static final float[] LINEAR = linears();

    private Srgb() {}

    /** The definition: the code, 0 to 255, of a linear value; below 0 and NaN count as 0, above 1 as 1. */
    static int formula(float linear) {
        double v = linear > 0 ? Math.min(linear, 1.0) : 0;
        double s = v <= 0.0031308 ? 12.92 * v : 1.055 * StrictMath.pow(v, 1 / 2.4) - 0.055;
        return (int) StrictMath.floor(255 * s + 0.5);
    }

    /** The same as {@link #formula}, fast. */
    static int encode(float linear) {
        int bits = Float.floatToRawIntBits(linear);
        return ENTRY[bits >>> BUCKET_SHIFT] + (bits & LOW_BITS) >> BUCKET_SHIFT & CODES;
    }

    /** The linear value, 0…1, of a code 0 to 255; {@code encode(linear(c)) == c}. */
    static float linear(int code) {
        return LINEAR[code];
    }

    private static float[] thresholds() {
        float[] thresholds = new float[257];
        for (int code = 1; code < 256; code++) {
            // The bits of floats ≥ 0 are ordered as the floats are, so that bisection runs on them.
            int below = 0;
            int above = WHITE_BITS;
            while (above - below > 1) {
                int middle = (below + above) >>> 1;
                if (formula(Float.intBitsToFloat(middle)) >= code) {
                    above = middle;
                } else {
                    below = middle;
                }
            }
            thresholds[code] = Float.intBitsToFloat(above);
        }
        thresholds[256] = Float.POSITIVE_INFINITY;
        return thresholds;
    }

    private static int[] entries() {
        int[] entries = new int[1 << Integer.SIZE - BUCKET_SHIFT];
        int white = WHITE_BITS >> BUCKET_SHIFT;
        for (int i = LEAST_BITS >> BUCKET_SHIFT; i < white; i++) {
            int start = i << BUCKET_SHIFT;
            int code = formula(Float.intBitsToFloat(start));
            int next = Float.floatToRawIntBits(THRESHOLD[code + 1]) - start;
            entries[i] = (code << BUCKET_SHIFT) + (next <= LOW_BITS ? LOW_BITS + 1 - next : 0);
        }
        int infinity = INFINITY_BITS >> BUCKET_SHIFT;
        Arrays.fill(entries, white, infinity, CODES << BUCKET_SHIFT);
        entries[infinity] = (CODES << BUCKET_SHIFT) + LOW_BITS;
        return entries;
    }

    private static float[] linears() {
        float[] linears = new float[256];
        for (int code = 0; code < 256; code++) {
            linears[code] = (float) SrgbCurve.linear(code / 255.0);
        }
        return linears;
    }
}
