package lightning.render.image;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import lightning.base.text.RefusalException;

/**
 * Lookup table of a rising curve from linear values to codes 0 to 255. For every float it gives the same code as the formula {@code
 * floor(255 · curve + 0.5)}.
 *
 * @param entry     one number for each bucket of floats, ordered by their bits as unsigned numbers; half a megabyte, of which a
 *                  picture touches a few kilobytes. Added to the low bits of a float, it gives the code in the next eight bits: the
 *                  code of the bucket's smallest float, plus a fraction whose sum carries from the threshold on. Infinity shares
 *                  its bucket with NaNs, whose sum carries to 256, as code 0. Negative floats and other NaNs have 0
 * @param threshold {@code float[257]}: the smallest float of each code, and an end that is never reached
 */
record CodeTable(int[] entry, float[] threshold) {
    // Arrays in a record: written once by their creator, never after.

    /** Bits of 2⁻¹³, below which every curve must have code 0. */
    private static final int MIN_BITS = Float.floatToRawIntBits(0x1p-13f);
    private static final int INFINITY_BITS = Float.floatToRawIntBits(Float.POSITIVE_INFINITY);
    /** 256 buckets per factor of two, so that none contains more than one threshold. */
    private static final int BUCKET_SHIFT = 23 - 8;
    private static final int LOW_BITS = (1 << BUCKET_SHIFT) - 1;
    private static final int CODES = 0xFF;
    private static final double WHITE = 255;

    /**
     * Creates the table of a curve.
     *
     * @param curve rising function from linear values above 0 to 0…1
     * @param white a power of two from which on the curve is 1
     * @throws IllegalArgumentException if the codes of the curve are too close together for the table
     */
    static CodeTable of(DoubleUnaryOperator curve, float white) {
        int whiteBits = Float.floatToRawIntBits(white);
        float[] thresholds = thresholds(curve, whiteBits);
        return new CodeTable(entries(curve, thresholds, whiteBits), thresholds);
    }

    /** Returns the code of a linear value by the formula; below 0 and NaN count as 0. */
    static int formula(DoubleUnaryOperator curve, float linear) {
        return linear > 0 ? (int) StrictMath.floor(WHITE * Math.clamp(curve.applyAsDouble(linear), 0, 1) + 0.5) : 0;
    }

    /** Returns the same code as {@link #formula} from the table. */
    int encode(float linear) {
        int bits = Float.floatToRawIntBits(linear);
        return entry[bits >>> BUCKET_SHIFT] + (bits & LOW_BITS) >> BUCKET_SHIFT & CODES;
    }

    private static float[] thresholds(DoubleUnaryOperator curve, int white) {
        float[] thresholds = new float[257];
        for (int code = 1; code < 256; code++) {
            // The bits of floats ≥ 0 have the order of the floats, so bisection works on them.
            int below = 0;
            int above = white;
            while (above - below > 1) {
                int middle = (below + above) >>> 1;
                if (formula(curve, Float.intBitsToFloat(middle)) >= code) {
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

    private static int[] entries(DoubleUnaryOperator curve, float[] thresholds, int whiteBits) {
        for (int code = 1; code < 256; code++) {
            int bits = Float.floatToRawIntBits(thresholds[code]);
            if (bits < MIN_BITS || bits >> BUCKET_SHIFT == Float.floatToRawIntBits(thresholds[code + 1]) >> BUCKET_SHIFT) {
                throw new RefusalException("the codes of the curve are too close together at " + thresholds[code]);
            }
        }
        int[] entries = new int[1 << Integer.SIZE - BUCKET_SHIFT];
        int white = whiteBits >> BUCKET_SHIFT;
        for (int i = MIN_BITS >> BUCKET_SHIFT; i < white; i++) {
            int start = i << BUCKET_SHIFT;
            int code = formula(curve, Float.intBitsToFloat(start));
            int next = Float.floatToRawIntBits(thresholds[code + 1]) - start;
            entries[i] = (code << BUCKET_SHIFT) + (next <= LOW_BITS ? LOW_BITS + 1 - next : 0);
        }
        int infinity = INFINITY_BITS >> BUCKET_SHIFT;
        Arrays.fill(entries, white, infinity, CODES << BUCKET_SHIFT);
        entries[infinity] = (CODES << BUCKET_SHIFT) + LOW_BITS;
        return entries;
    }
}
