package lightning.document.manipulation;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/** Composition of Euler angles about x, y and z with a rotation about one fixed axis. */
final class EulerRotation {
    /** Cosine of the angle about y below which the rotation is in gimbal lock. */
    private static final double GIMBAL_LOCK_COSINE = 1e-6;
    /** Rounding of angles, in steps per degree, so that right angles stay exact. */
    private static final double STEPS_PER_DEGREE = 1e4;

    private EulerRotation() {}

    /**
     * Returns the angles of the rotation {@code angles} followed by {@code degrees} about an axis. Chooses the solution nearest to the
     * previous angles.
     *
     * @param angles about x, y, z in this order, degrees
     * @param axis   0, 1 or 2
     */
    static Vec3 rotate(Vec3 angles, int axis, double degrees) {
        if (axis == 2) {
            return rounded(new Vec3(angles.x(), angles.y(), nearestEquivalent(angles.z() + degrees, angles.z())));
        }
        Transform m = Transform.rotation(NodeGizmo.unit(axis).times(degrees)).times(Transform.rotation(angles));
        // Rows of z·y·x: … , …, (−sin y, cos y sin x, cos y cos x); its first column is (cos z cos y, sin z cos y, −sin y).
        double cosine = Math.hypot(m.m21(), m.m22());
        double y = degrees(-m.m20(), cosine);
        if (cosine < GIMBAL_LOCK_COSINE) {
            double difference = m.m20() < 0 ? degrees(m.m01(), m.m02()) : degrees(-m.m01(), -m.m02());
            double z = m.m20() < 0 ? angles.x() - difference : difference - angles.x();
            return rounded(new Vec3(angles.x(), nearestEquivalent(y, angles.y()), nearestEquivalent(z, angles.z())));
        }
        Vec3 first = nearestEquivalent(new Vec3(degrees(m.m21(), m.m22()), y, degrees(m.m10(), m.m00())), angles);
        Vec3 second = nearestEquivalent(new Vec3(first.x() + 180, 180 - y, first.z() + 180), angles);
        return rounded(distance(first, angles) <= distance(second, angles) ? first : second);
    }

    private static double degrees(double sine, double cosine) {
        return Math.toDegrees(Math.atan2(sine, cosine));
    }

    private static double distance(Vec3 a, Vec3 b) {
        return Math.abs(a.x() - b.x()) + Math.abs(a.y() - b.y()) + Math.abs(a.z() - b.z());
    }

    private static Vec3 nearestEquivalent(Vec3 angles, Vec3 to) {
        return new Vec3(nearestEquivalent(angles.x(), to.x()), nearestEquivalent(angles.y(), to.y()),
                nearestEquivalent(angles.z(), to.z()));
    }

    /** Returns the equivalent of an angle that is within half a turn of another. */
    private static double nearestEquivalent(double angle, double to) {
        return angle - 360 * Math.rint((angle - to) / 360);
    }

    private static Vec3 rounded(Vec3 v) {
        return new Vec3(rounded(v.x()), rounded(v.y()), rounded(v.z()));
    }

    private static double rounded(double v) {
        return Math.rint(v * STEPS_PER_DEGREE) / STEPS_PER_DEGREE + 0.0;
    }
}
