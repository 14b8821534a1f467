package lightning.scene;

import lightning.math.Transform;
import lightning.math.Vec3;

/**
 * Where a shape or a group stands: scaled first, then rotated about x, y and z in this order, then
 * moved.
 *
 * @param at     position, scene units
 * @param rotate angles about x, y, z, degrees
 * @param scale  factors along the shape's own axes, none of them 0 (negative mirrors)
 */
public record Placement(Vec3 at, Vec3 rotate, Vec3 scale) {
    public static final Placement IDENTITY = new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);

    public Placement {
        Limits.position("at", at);
        Limits.range("rotate", rotate, -Limits.MAX_ROTATION, Limits.MAX_ROTATION);
        Limits.range("scale", scale, -Limits.MAX_SCALE, Limits.MAX_SCALE);
        // Most things are neither turned nor scaled: what a million of them have in common they share.
        rotate = rotate.equals(Vec3.ZERO) ? Vec3.ZERO : rotate;
        scale = scale.equals(Vec3.ONE) ? Vec3.ONE : scale;
        double least = least(scale);
        if (least < Limits.MIN_SCALE) {
            throw new IllegalArgumentException("scale must be at least " + Limits.text(Limits.MIN_SCALE)
                    + " in absolute value on every axis, was " + Limits.text(least));
        }
    }

    /** The smallest absolute scale factor. */
    public double leastScale() {
        return least(scale);
    }

    /** The largest absolute scale factor. */
    public double mostScale() {
        return scale.maxAbs();
    }

    private static double least(Vec3 v) {
        return Math.min(Math.min(Math.abs(v.x()), Math.abs(v.y())), Math.abs(v.z()));
    }

    /**
     * The inverse of {@link #transform}, without translation: turned back, then scaled back. Nothing is
     * subtracted on the way, so that it exists and is accurate where the determinant of the map, or of a
     * product of such maps, is lost in rounding.
     */
    public Transform directionsBack() {
        Vec3 back = new Vec3(1 / scale.x(), 1 / scale.y(), 1 / scale.z());
        return Transform.scaling(back).times(Transform.rotation(rotate).transposed());
    }

    public Transform transform() {
        return Transform.translation(at).times(Transform.rotation(rotate)).times(Transform.scaling(scale));
    }
}
