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
    private final Vec3 rotation;

    /**
     * A placement within all limits.
     *
     * @param position     position, scene units
     * @param rotation angles about x, y, z, degrees
     * @param scale  factors along the shape's own axes, none of them 0 (negative mirrors)
     * @throws IllegalArgumentException if one is beyond what {@link SceneLimits} allows
     */
    public Placement(Vec3 position, Vec3 rotation, Vec3 scale) {
        SceneLimits.checkPosition("at", position);
        SceneLimits.checkRange("rotate", rotation, -SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION);
        SceneLimits.checkRange("scale", scale, -SceneLimits.MAX_SCALE, SceneLimits.MAX_SCALE);
        double minFactor = minAbs(scale);
        if (minFactor < SceneLimits.MIN_SCALE) {
            throw new IllegalArgumentException("scale must be at least " + SceneLimits.format(SceneLimits.MIN_SCALE)
                    + " in absolute value on every axis, was " + SceneLimits.format(minFactor));
        }
        x = position.x();
        y = position.y();
        z = position.z();
        scaleX = scale.x();
        scaleY = scale.y();
        scaleZ = scale.z();
        this.rotation = rotation.equals(Vec3.ZERO) ? Vec3.ZERO : rotation;
    }

    /** Position, scene units. */
    public Vec3 position() {
        return new Vec3(x, y, z);
    }

    /** Angles about x, y, z, degrees. */
    public Vec3 rotation() {
        return rotation;
    }

    /** Factors along the shape's own axes. */
    public Vec3 scale() {
        return new Vec3(scaleX, scaleY, scaleZ);
    }

    public Placement withPosition(Vec3 v) {
        return new Placement(v, rotation, scale());
    }

    public Placement withRotation(Vec3 v) {
        return new Placement(position(), v, scale());
    }

    public Placement withScale(Vec3 v) {
        return new Placement(position(), rotation, v);
    }

    /** The smallest absolute scale factor. */
    public double minScale() {
        return minAbs(scale());
    }

    /** The largest absolute scale factor. */
    public double maxScale() {
        return scale().maxAbs();
    }

    private static double minAbs(Vec3 v) {
        return Math.min(Math.min(Math.abs(v.x()), Math.abs(v.y())), Math.abs(v.z()));
    }

    /**
     * The inverse of {@link #transform}, without translation: turned back, then scaled back. Nothing is
     * subtracted on the way, so that it exists and is accurate where the determinant of the map, or of a
     * product of such maps, is lost in rounding.
     */
    public Transform directionsToLocal() {
        Vec3 inverseScale = new Vec3(1 / scaleX, 1 / scaleY, 1 / scaleZ);
        return Transform.scaling(inverseScale).times(Transform.rotation(rotation).transposed());
    }

    public Transform transform() {
        return Transform.translation(position()).times(Transform.rotation(rotation)).times(Transform.scaling(scale()));
    }

    @Override
    public boolean equals(Object o) {
        return this == o
                || o instanceof Placement p && position().equals(p.position()) && rotation.equals(p.rotation) && scale().equals(p.scale());
    }

    @Override
    public int hashCode() {
        return 31 * (31 * position().hashCode() + rotation.hashCode()) + scale().hashCode();
    }

    @Override
    public String toString() {
        return "at " + position() + ", rotate " + rotation + ", scale " + scale();
    }
}
