package lightning.format.exchange.usd;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/** Right-handed axes of a light in the stage; it shines along −z. */
record LightFrame(Vec3 x, Vec3 y, Vec3 z) {
    private static final double PARALLEL = 1e-12;

    /** Returns the axes of a direction and a unit vector perpendicular to it. */
    static LightFrame of(Vec3 right, Vec3 direction) {
        Vec3 z = direction.times(-1);
        return new LightFrame(right, z.cross(right), z);
    }

    /** Returns the axes of a prim without its scale and shear; the z axis and the plane of y stay. */
    static LightFrame of(Transform m) {
        Vec3 z = m.transformVector(new Vec3(0, 0, 1)).normalized();
        Vec3 x = m.transformVector(Vec3.Y).normalized().cross(z).normalized();
        return new LightFrame(x, z.cross(x), z);
    }

    /** Returns the rotation from these axes to others. */
    Transform to(LightFrame other) {
        return other.columns().times(columns().transposed());
    }

    /** Returns the smallest rotation from one unit vector to another. */
    static Transform shortest(Vec3 from, Vec3 to) {
        Vec3 axis = from.cross(to);
        if (axis.maxAbs() < PARALLEL) {
            if (from.dot(to) > 0) {
                return Transform.IDENTITY;
            }
            axis = from.cross(Math.abs(from.x()) < 0.5 ? new Vec3(1, 0, 0) : Vec3.Y);
        }
        Vec3 unit = axis.normalized();
        return new LightFrame(unit, from.cross(unit), from).to(new LightFrame(unit, to.cross(unit), to));
    }

    private Transform columns() {
        return new Transform(x.x(), y.x(), z.x(), 0, x.y(), y.y(), z.y(), 0, x.z(), y.z(), z.z(), 0);
    }
}
