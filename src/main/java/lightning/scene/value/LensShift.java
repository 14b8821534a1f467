package lightning.scene.value;

/**
 * Lens shift of a camera: moves the picture in the image plane without turning the camera, so that parallel lines of a facade stay parallel.
 *
 * @param x to the right, as a share of the picture's width
 * @param y up, as a share of the picture's height
 */
public record LensShift(double x, double y) {
    public static final LensShift NONE = new LensShift(0, 0);

    public LensShift {
        SceneLimits.checkRange("shift x", x, -SceneLimits.MAX_SHIFT, SceneLimits.MAX_SHIFT);
        SceneLimits.checkRange("shift y", y, -SceneLimits.MAX_SHIFT, SceneLimits.MAX_SHIFT);
        // Removes the sign of zero, so that equal shifts are equal records.
        x += 0.0;
        y += 0.0;
    }

    /** Returns whether a camera can have this shift: at most {@link SceneLimits#MAX_SHIFT} pictures in each direction. */
    public static boolean isValid(double x, double y) {
        return Math.abs(x) <= SceneLimits.MAX_SHIFT && Math.abs(y) <= SceneLimits.MAX_SHIFT;
    }
}
