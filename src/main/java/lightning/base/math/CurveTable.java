package lightning.base.math;

import java.util.function.DoubleUnaryOperator;

/**
 * Piecewise linear approximation of a curve over all floats from 0 on, with 256 segments per factor of two.
 *
 * @param start the curve at the smallest float of each bucket, and at that of the next bucket
 */
public record CurveTable(float[] start) {
    // An array in a record: written once by its creator, never after.

    private static final int BUCKET_SHIFT = 23 - 8;
    private static final int LOW_BITS = (1 << BUCKET_SHIFT) - 1;
    private static final int BUCKETS = Float.floatToRawIntBits(Float.POSITIVE_INFINITY) >> BUCKET_SHIFT;
    private static final double SHARE = 1.0 / (1 << BUCKET_SHIFT);

    /**
     * Creates the table of a curve.
     *
     * @param curve function from values ≥ 0 to 0…1
     */
    public static CurveTable of(DoubleUnaryOperator curve) {
        float[] start = new float[BUCKETS + 2];
        for (int i = 0; i < BUCKETS; i++) {
            start[i] = (float) Math.clamp(curve.applyAsDouble(Float.intBitsToFloat(i << BUCKET_SHIFT)), 0, 1);
        }
        start[BUCKETS] = start[BUCKETS - 1];
        start[BUCKETS + 1] = start[BUCKETS];
        return new CurveTable(start);
    }

    /** Returns the curve at a value; below 0 and NaN count as 0. */
    public double value(float linear) {
        if (!(linear > 0)) {
            return start[0];
        }
        int bits = Float.floatToRawIntBits(linear);
        int i = bits >>> BUCKET_SHIFT;
        return start[i] + (start[i + 1] - start[i]) * ((bits & LOW_BITS) * SHARE);
    }
}
