package lightning.base.math;

/** Affine map: a 3×3 matrix {@code m} in rows and a translation {@code t}, p ↦ m·p + t. */
public record Transform(
        double m00, double m01, double m02, double t0,
        double m10, double m11, double m12, double t1,
        double m20, double m21, double m22, double t2) {

    public static final Transform IDENTITY = new Transform(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

    public static Transform translation(Vec3 t) {
        return new Transform(1, 0, 0, t.x(), 0, 1, 0, t.y(), 0, 0, 1, t.z());
    }

    public static Transform scaling(Vec3 s) {
        return new Transform(s.x(), 0, 0, 0, 0, s.y(), 0, 0, 0, 0, s.z(), 0);
    }

    /**
     * Returns the rotation about x, then y, then z, each counter-clockwise seen from the positive axis towards the origin. Multiples of a
     * quarter turn give exact zeros and ones.
     *
     * @param degrees the three angles, in degrees
     */
    public static Transform rotation(Vec3 degrees) {
        double cx = cosDegrees(degrees.x());
        double sx = sinDegrees(degrees.x());
        double cy = cosDegrees(degrees.y());
        double sy = sinDegrees(degrees.y());
        double cz = cosDegrees(degrees.z());
        double sz = sinDegrees(degrees.z());
        Transform rx = new Transform(1, 0, 0, 0, 0, cx, -sx, 0, 0, sx, cx, 0);
        Transform ry = new Transform(cy, 0, sy, 0, 0, 1, 0, 0, -sy, 0, cy, 0);
        Transform rz = new Transform(cz, -sz, 0, 0, sz, cz, 0, 0, 0, 0, 1, 0);
        return rz.times(ry).times(rx);
    }

    /** Returns this map with the absolute value of every number. */
    public Transform absolute() {
        return new Transform(Math.abs(m00), Math.abs(m01), Math.abs(m02), Math.abs(t0), Math.abs(m10), Math.abs(m11), Math.abs(m12),
                Math.abs(t1),
                Math.abs(m20), Math.abs(m21), Math.abs(m22), Math.abs(t2));
    }

    /** Returns this map without its translation. */
    public Transform linearPart() {
        return new Transform(m00, m01, m02, 0, m10, m11, m12, 0, m20, m21, m22, 0);
    }

    /** Returns the sum of all numbers. */
    public Transform plus(Transform o) {
        return new Transform(m00 + o.m00, m01 + o.m01, m02 + o.m02, t0 + o.t0, m10 + o.m10, m11 + o.m11, m12 + o.m12, t1 + o.t1,
                m20 + o.m20, m21 + o.m21, m22 + o.m22, t2 + o.t2);
    }

    /** Returns every number times a factor. */
    public Transform times(double f) {
        return new Transform(f * m00, f * m01, f * m02, f * t0, f * m10, f * m11, f * m12, f * t1, f * m20, f * m21, f * m22, f * t2);
    }

    /** Returns the transposed matrix without translation: the inverse of a rotation. */
    public Transform transposed() {
        return new Transform(m00, m10, m20, 0, m01, m11, m21, 0, m02, m12, m22, 0);
    }

    /**
     * Returns the sine of an angle in degrees, exact at multiples of 90. Removes whole turns first: subtracting 90 from a million degrees
     * would round by more than the error of a double's sine.
     */
    public static double sinDegrees(double degrees) {
        return cosDegrees(degrees % 360 - 90);
    }

    /** Returns the cosine of an angle in degrees, exact at multiples of 90. */
    public static double cosDegrees(double degrees) {
        double turn = Math.abs(degrees % 360);
        if (turn == 90 || turn == 270) {
            return 0;
        }
        if (turn == 0) {
            return 1;
        }
        return turn == 180 ? -1 : StrictMath.cos(StrictMath.toRadians(turn));
    }

    /** Returns this map applied after {@code o}: p ↦ this(o(p)). */
    public Transform times(Transform o) {
        return new Transform(
                m00 * o.m00 + m01 * o.m10 + m02 * o.m20,
                m00 * o.m01 + m01 * o.m11 + m02 * o.m21,
                m00 * o.m02 + m01 * o.m12 + m02 * o.m22,
                m00 * o.t0 + m01 * o.t1 + m02 * o.t2 + t0,
                m10 * o.m00 + m11 * o.m10 + m12 * o.m20,
                m10 * o.m01 + m11 * o.m11 + m12 * o.m21,
                m10 * o.m02 + m11 * o.m12 + m12 * o.m22,
                m10 * o.t0 + m11 * o.t1 + m12 * o.t2 + t1,
                m20 * o.m00 + m21 * o.m10 + m22 * o.m20,
                m20 * o.m01 + m21 * o.m11 + m22 * o.m21,
                m20 * o.m02 + m21 * o.m12 + m22 * o.m22,
                m20 * o.t0 + m21 * o.t1 + m22 * o.t2 + t2);
    }

    public Vec3 transformPoint(Vec3 p) {
        return new Vec3(
                m00 * p.x() + m01 * p.y() + m02 * p.z() + t0,
                m10 * p.x() + m11 * p.y() + m12 * p.z() + t1,
                m20 * p.x() + m21 * p.y() + m22 * p.z() + t2);
    }

    /** Maps a direction: without the translation. */
    public Vec3 transformVector(Vec3 v) {
        return new Vec3(
                m00 * v.x() + m01 * v.y() + m02 * v.z(),
                m10 * v.x() + m11 * v.y() + m12 * v.z(),
                m20 * v.x() + m21 * v.y() + m22 * v.z());
    }
}
