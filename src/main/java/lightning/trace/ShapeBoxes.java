package lightning.trace;

/**
 * Boxes around the shapes as floats, {@code float[6 * count]}: min x y z, max x y z of shape 0, then of 1, ….
 *
 * <p>Each is padded by 2⁻¹⁹ of the scene's extent, the largest coordinate of any shape seen from the
 * camera. That covers everything by which a ray that {@link Solids} lets hit the shape may miss its box:
 * the rounding of the box, of a ray that starts within the extent, and of a distance to float, together below
 * 11·2⁻²⁴ of the extent, and the error of {@code Solids} in double, about 2⁻²⁶ of it where a cone is grazed.
 *
 * <p>Where a shape is so skewed that its inverse map hardly inverts, or a scene so large that floats
 * would overflow, boxes cannot be trusted: then all are infinite and every shape is tested.
 */
final class ShapeBoxes {
    private static final double PAD = 0x1p-19;
    private static final double MAX_EXTENT = 0x1p60;

    private ShapeBoxes() {}

    static float[] of(ShapeTable shapes) {
        double extent = 0;
        for (int s = 0; s < shapes.count; s++) {
            for (int i = 6 * s; i < 6 * s + 6; i++) {
                extent = Math.max(extent, Math.abs(shapes.bounds[i]) + shapes.slack[s]);
            }
        }
        boolean trusted = extent <= MAX_EXTENT;
        float[] boxes = new float[6 * shapes.count];
        for (int s = 0; s < shapes.count; s++) {
            double pad = trusted ? extent * PAD + shapes.slack[s] : Double.POSITIVE_INFINITY;
            for (int i = 6 * s; i < 6 * s + 3; i++) {
                boxes[i] = Math.nextDown((float) (shapes.bounds[i] - pad));
                boxes[i + 3] = Math.nextUp((float) (shapes.bounds[i + 3] + pad));
            }
        }
        return boxes;
    }
}
