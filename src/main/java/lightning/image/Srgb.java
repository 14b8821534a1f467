package lightning.image;

/**
 * The sRGB encoding to and from 8 bits (IEC 61966-2-1), correctly rounded.
 *
 * <p>For a linear value v in 0…1 the code is {@code round(255 · s)}, where {@code s = 12.92 · v} up to v = 0.0031308 and
 * {@code s = 1.055 · v^(1/2.4) − 0.055} above. {@link #formula} is just that; {@link #encode} gives the same code for
 * every float from a table, without a power.
 */
final class Srgb {

    /** Below it every code is 0: 12.92 · 255 · 2⁻¹³ = 0.40 rounds down. */
    private static final float LEAST = 0x1p-13f;

    /** 256 buckets for each factor of two; a bucket then never holds more than one threshold (a test checks it). */
    private static final int BUCKET_SHIFT = 23 - 8;

    private static final int LEAST_BUCKET = bucket(LEAST);

    /** {@code THRESHOLD[c]} is the smallest float whose code is c; one more that is never reached. */
    static final float[] THRESHOLD = thresholds();

    /** The code of the smallest float of each bucket. */
    private static final byte[] FIRST_CODE = firstCodes();

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
        // Both comparisons are false for NaN, which so becomes LEAST and black.
        float v = linear > LEAST ? linear : LEAST;
        v = v < 1 ? v : 1;
        int code = FIRST_CODE[bucket(v) - LEAST_BUCKET] & 0xFF;
        return v >= THRESHOLD[code + 1] ? code + 1 : code;
    }

    /** The linear value, 0…1, of a code 0 to 255; {@code encode(linear(c)) == c}. */
    static float linear(int code) {
        return LINEAR[code];
    }

    private static int bucket(float v) {
        return Float.floatToRawIntBits(v) >> BUCKET_SHIFT;
    }

    private static float[] thresholds() {
        float[] thresholds = new float[257];
        for (int code = 1; code < 256; code++) {
            // The bits of floats ≥ 0 are ordered as the floats are, so that bisection runs on them.
            int below = 0;
            int above = Float.floatToRawIntBits(1);
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

    private static byte[] firstCodes() {
        byte[] codes = new byte[bucket(1) - LEAST_BUCKET + 1];
        for (int i = 0; i < codes.length; i++) {
            codes[i] = (byte) formula(Float.intBitsToFloat(i + LEAST_BUCKET << BUCKET_SHIFT));
        }
        return codes;
    }

    private static float[] linears() {
        float[] linears = new float[256];
        for (int code = 0; code < 256; code++) {
            double s = code / 255.0;
            linears[code] = (float) (s <= 0.04045 ? s / 12.92 : StrictMath.pow((s + 0.055) / 1.055, 2.4));
        }
        return linears;
    }
}
