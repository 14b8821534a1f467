package lightning.base.math;

/** Rotation of vectors about axes, by Rodrigues' formula. */
public final class VectorRotation {
    private VectorRotation() {}

    /**
     * Rotates {@code v} counter-clockwise, seen against the axis.
     *
     * @param axis    axis of length 1
     * @param radians the angle
     */
    public static Vec3 rotate(Vec3 axis, double radians, Vec3 v) {
        double c = Math.cos(radians);
        double s = Math.sin(radians);
        return v.times(c).plus(axis.cross(v).times(s)).plus(axis.times(axis.dot(v) * (1 - c)));
    }

    /**
     * Returns the unit direction on the shorter arc between two directions; for opposite directions, on any arc.
     *
     * @param t 0 gives {@code from}, 1 gives {@code to}
     */
    public static Vec3 slerp(Vec3 from, Vec3 to, double t) {
        Vec3 a = from.normalized();
        Vec3 b = to.normalized();
        Vec3 axis = a.cross(b);
        double angle = Math.atan2(axis.length(), a.dot(b));
        if (!(axis.length() > 1e-12)) {
            if (a.dot(b) > 0) {
                return a;
            }
            axis = a.cross(Math.abs(a.x()) < 0.9 ? new Vec3(1, 0, 0) : Vec3.Y);
        }
        return rotate(axis.normalized(), angle * t, a).normalized();
    }
}
