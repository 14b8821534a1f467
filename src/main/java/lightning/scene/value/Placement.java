package lightning.scene.value;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;

/**
 * Placement of a shape or a group: scale, then rotation about x, y and z in this order, then translation. The numbers are fields of this
 * class: a separate scale object would take 40 more bytes for each of a million shapes. Equality compares all bits.
 */
public final class Placement {
    public static final Placement IDENTITY = new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);

    private final double x;
    private final double y;
    private final double z;
    private final double scaleX;
    private final double scaleY;
    private final double scaleZ;
    /** Most shapes are not rotated; they share one vector. */
    private final Vec3 rotation;

    /**
     * Creates a placement within all limits.
     *
     * @param position position, scene units
     * @param rotation angles about x, y, z, degrees
     * @param scale    factors along the shape's own axes, none of them 0 (negative mirrors)
     * @throws RefusalException if one is beyond the limits of {@link SceneLimits}
     */
    public Placement(Vec3 position, Vec3 rotation, Vec3 scale) {
        SceneLimits.checkPosition("at", position);
        SceneLimits.checkRange("rotate", rotation, -SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION);
        SceneLimits.checkRange("scale", scale, -SceneLimits.MAX_SCALE, SceneLimits.MAX_SCALE);
        double minFactor = minAbs(scale);
        if (minFactor < SceneLimits.MIN_SCALE) {
            throw new RefusalException("scale must be at least " + SceneLimits.format(SceneLimits.MIN_SCALE)
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

    /** Returns the position, scene units. */
    public Vec3 position() {
        return new Vec3(x, y, z);
    }

    /** Returns the angles about x, y, z, degrees. */
    public Vec3 rotation() {
        return rotation;
    }

    /** Returns the factors along the shape's own axes. */
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

    /** Returns the smallest absolute scale factor. */
    public double minScale() {
        return minAbs(scale());
    }

    /** Returns the largest absolute scale factor. */
    public double maxScale() {
        return scale().maxAbs();
    }

    private static double minAbs(Vec3 v) {
        return Math.min(Math.min(Math.abs(v.x()), Math.abs(v.y())), Math.abs(v.z()));
    }

    /**
     * Returns the inverse of {@link #transform} without translation: inverse rotation, then inverse scale. Subtracts nothing, so it is
     * accurate even if the determinant of the map, or of a product of such maps, is lost in rounding.
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
