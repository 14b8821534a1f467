package lightning.base.math;

/** Point, direction or triple of factors in three dimensions. */
public record Vec3(double x, double y, double z) {
    public static final Vec3 ZERO = new Vec3(0, 0, 0);
    public static final Vec3 ONE = new Vec3(1, 1, 1);
    public static final Vec3 Y = new Vec3(0, 1, 0);

    public Vec3 plus(Vec3 v) {
        return new Vec3(x + v.x, y + v.y, z + v.z);
    }

    public Vec3 minus(Vec3 v) {
        return new Vec3(x - v.x, y - v.y, z - v.z);
    }

    public Vec3 times(double s) {
        return new Vec3(x * s, y * s, z * s);
    }

    public Vec3 negated() {
        return new Vec3(-x, -y, -z);
    }

    public double dot(Vec3 v) {
        return x * v.x + y * v.y + z * v.z;
    }

    public Vec3 cross(Vec3 v) {
        return new Vec3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
    }

    /** Returns the Euclidean length, without overflow guard: components beyond 1e150 give infinity. */
    public double length() {
        return Math.sqrt(dot(this));
    }

    /** Returns the largest absolute value of the three components. */
    public double maxAbs() {
        return Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z));
    }

    /**
     * Returns this direction at length 1. Scales by the largest component first, so that no finite vector overflows or underflows.
     *
     * @throws ArithmeticException if all components are zero or one is not finite
     */
    public Vec3 normalized() {
        double scale = maxAbs();
        if (!(scale > 0) || !Double.isFinite(x + y + z)) {
            throw new ArithmeticException("cannot normalize " + this);
        }
        double sx = x / scale;
        double sy = y / scale;
        double sz = z / scale;
        double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
        return new Vec3(sx / length, sy / length, sz / length);
    }
}
