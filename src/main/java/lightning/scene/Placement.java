package lightning.scene;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Where a shape or a group stands: scaled first, then rotated about x, y and z in this order, then
 * moved. Its numbers are its own fields: of a million shapes each would take 40 bytes more with its scale as an object beside it. Two are
 * equal when all bits are.
 */
public final class Placement {
    public static final Placement IDENTITY = new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);

    private final double x;
    private final double y;
    private final double z;
    private final double scaleX;
    private final double scaleY;
    private final double scaleZ;
    /** Most things are not turned: what a million of them have in common they share. */
    private final Vec3 rotate;

    /**
     * A placement within all limits.
     *
     * @param at     position, scene units
     * @param rotate angles about x, y, z, degrees
     * @param scale  factors along the shape's own axes, none of them 0 (negative mirrors)
     * @throws IllegalArgumentException if one is beyond what {@link Limits} allows
     */
    public Placement(Vec3 at, Vec3 rotate, Vec3 scale) {
        Limits.position("at", at);
        Limits.range("rotate", rotate, -Limits.MAX_ROTATION, Limits.MAX_ROTATION);
        Limits.range("scale", scale, -Limits.MAX_SCALE, Limits.MAX_SCALE);
        double least = least(scale);
        if (least < Limits.MIN_SCALE) {
            throw new IllegalArgumentException("scale must be at least " + Limits.text(Limits.MIN_SCALE)
                    + " in absolute value on every axis, was " + Limits.text(least));
        }
        x = at.x();
        y = at.y();
        z = at.z();
        scaleX = scale.x();
        scaleY = scale.y();
        scaleZ = scale.z();
        this.rotate = rotate.equals(Vec3.ZERO) ? Vec3.ZERO : rotate;
    }

    /** Position, scene units. */
    public Vec3 at() {
        return new Vec3(x, y, z);
    }

    /** Angles about x, y, z, degrees. */
    public Vec3 rotate() {
        return rotate;
    }

    /** Factors along the shape's own axes. */
    public Vec3 scale() {
        return new Vec3(scaleX, scaleY, scaleZ);
    }

    public Placement withAt(Vec3 v) {
        return new Placement(v, rotate, scale());
    }

    public Placement withRotate(Vec3 v) {
        return new Placement(at(), v, scale());
    }

    public Placement withScale(Vec3 v) {
        return new Placement(at(), rotate, v);
    }

    /** The smallest absolute scale factor. */
    public double leastScale() {
        return least(scale());
    }

    /** The largest absolute scale factor. */
    public double mostScale() {
        return scale().maxAbs();
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
        Vec3 back = new Vec3(1 / scaleX, 1 / scaleY, 1 / scaleZ);
        return Transform.scaling(back).times(Transform.rotation(rotate).transposed());
    }

    public Transform transform() {
        return Transform.translation(at()).times(Transform.rotation(rotate)).times(Transform.scaling(scale()));
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Placement p && at().equals(p.at()) && rotate.equals(p.rotate) && scale().equals(p.scale());
    }

    @Override
    public int hashCode() {
        return 31 * (31 * at().hashCode() + rotate.hashCode()) + scale().hashCode();
    }

    @Override
    public String toString() {
        return "at " + at() + ", rotate " + rotate + ", scale " + scale();
    }
}
