package lightning.render.gather.ray;

/**
 * Sums of the inverse lengths of a point's rays, in fixed point. Such a sum does not depend on the order of its terms, so that an edit
 * replaces the terms of some rays.
 */
public final class InverseLengths {
    /** Fixed-point value of a ray as long as the side of the point's largest cell. */
    private static final double ONE = 0x1p30;
    /** Value of all shorter rays than 2⁻¹⁶ sides. 2¹⁶ of them do not overflow. */
    private static final double MAX = 0x1p46;

    private InverseLengths() {}

    /**
     * Returns the term of a ray.
     *
     * @param length of the ray
     * @param side   of the largest cell at the point
     */
    public static long term(double length, double side) {
        return (long) Math.min(MAX, ONE * side / length);
    }

    /** Returns the harmonic mean length; {@code +∞} for a sum of 0. */
    public static float harmonicMean(long sum, int rays, double side) {
        return (float) (ONE * side * rays / sum);
    }
}
