package lightning.render.trace.primitive;

/**
 * Boxes around the primitives as floats, {@code float[6 * count]}: min x y z, max x y z of primitive 0, then of 1, ….
 *
 * <p>Each is padded by 2⁻¹⁹ of the scene's extent, the largest coordinate of any primitive seen from the
 * camera. That covers everything by which a ray that {@link lightning.render.trace.solid.SolidGeometry} lets hit the primitive may miss its box:
 * the rounding of the box, of a ray that starts within the extent, and of a distance to float, together below
 * 11·2⁻²⁴ of the extent, and the error of {@code Form} in double, about 2⁻²⁶ of it where a cone is grazed.
 * Where a primitive is far wider along one axis than along another, what rounds along the one counts for more along the
 * other; then a share of the extent is added to its pad ({@link BoxPadding#roundingShare}). Rays also start from where such a primitive is met:
 * the extent holds every pad.
 *
 * <p>Where a primitive is so skewed that its inverse map hardly inverts, its share is above ½, or a scene is so large that floats
 * would overflow, boxes cannot be trusted: then all are infinite and every primitive is tested.
 */
public final class PrimitiveBoxes {
    private static final double PADDING_SHARE = 0x1p-19;
    private static final double MAX_EXTENT = 0x1p60;

    private PrimitiveBoxes() {}

    /**
     * @param bounds what the primitives take up seen from the camera, {@code double[6 * count]}: min x y z, max x y z
     * @param padding  how far the map lets rays meet each outside of that; {@code +∞} if nobody knows
     * @param roundingShare  how far roundings of its form do, as a share of the extent
     */
    static float[] of(double[] bounds, double[] padding, double[] roundingShare) {
        double extent = 0;
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
