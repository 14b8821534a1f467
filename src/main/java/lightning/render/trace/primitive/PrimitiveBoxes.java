package lightning.render.trace.primitive;

/**
 * Padded boxes of the primitives as floats, {@code float[6 * count]}: min x y z, max x y z of primitive 0, then of 1, ….
 *
 * <p>Each box is padded by 2⁻¹⁹ of the scene's extent, the largest coordinate of any primitive or point of the lens relative to the camera. This
 * covers every distance outside the box at which {@link lightning.render.trace.solid.SolidGeometry} may report a hit. Rounding
 * of the box, of a ray origin within the extent, and of a distance to float are together below 11·2⁻²⁴ of the extent. The error
 * of {@code SolidGeometry} in double is about 2⁻²⁶ of it for grazing rays on a cone. Where a primitive is much wider along one
 * axis than another, rounding along one axis has more effect along the other; then a share of the extent is added to its
 * padding ({@link BoxPadding#roundingShare}). Rays also start at hits of such primitives, so the extent includes all paddings.
 *
 * <p>All boxes are infinite, and every primitive is tested, if boxes are unreliable: the inverse transform of a primitive is
 * nearly singular, its share is above ½, or the scene is so large that floats would overflow.
 */
public final class PrimitiveBoxes {
    private static final double PADDING_SHARE = 0x1p-19;
    private static final double MAX_EXTENT = 0x1p60;

    private PrimitiveBoxes() {}

    /**
     * @param bounds bounds of the primitives relative to the camera, {@code double[6 * count]}: min x y z, max x y z
     * @param padding distance outside its bounds at which each may be hit because of its transform; {@code +∞} if unknown
     * @param roundingShare the same for rounding in its {@code SolidGeometry}, relative to the extent
     * @param lens radius of the camera's lens, on which rays start
     */
    static float[] of(double[] bounds, double[] padding, double[] roundingShare, double lens) {
        double extent = lens;
        for (int s = 0; s < padding.length; s++) {
            double remainder = roundingShare[s] <= 0.5 ? 1 - roundingShare[s] : 0;
            for (int i = 6 * s; i < 6 * s + 6; i++) {
                extent = Math.max(extent, (Math.abs(bounds[i]) + padding[s]) / remainder);
            }
        }
        boolean trusted = extent <= MAX_EXTENT;
        float[] boxes = new float[6 * padding.length];
        for (int s = 0; s < padding.length; s++) {
            double pad = trusted ? extent * (PADDING_SHARE + roundingShare[s]) + padding[s] : Double.POSITIVE_INFINITY;
            for (int i = 6 * s; i < 6 * s + 3; i++) {
                boxes[i] = Math.nextDown((float) (bounds[i] - pad));
                boxes[i + 3] = Math.nextUp((float) (bounds[i + 3] + pad));
            }
        }
        return boxes;
    }
}
