package lightning.exchange;

import java.util.Optional;
import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.scene.Placement;

/** Takes maps apart into what a placement can say: scaled, then turned about x, y and z, then moved. */
final class Decomposition {
    /** The cosine of the angle between two axes from which on a map is taken to shear; rounding to float leaves less than 1e-6. */
    private static final double SHEAR = 1e-4;

    private Decomposition() {}

    /** The placement that is the map; empty where it shears, is flat in any direction or beyond a scene's limits. */
    static Optional<Placement> of(Transform m) {
        Vec3 x = new Vec3(m.m00(), m.m10(), m.m20());
        Vec3 y = new Vec3(m.m01(), m.m11(), m.m21());
        Vec3 z = new Vec3(m.m02(), m.m12(), m.m22());
        double sx = x.length();
        double sy = y.length();
        double sz = z.length();
        if (!(Math.abs(x.dot(y)) <= SHEAR * sx * sy && Math.abs(y.dot(z)) <= SHEAR * sy * sz && Math.abs(z.dot(x)) <= SHEAR * sz * sx)) {
            return Optional.empty();
        }
        // A map that mirrors does so along x.
        double mirror = x.cross(y).dot(z) < 0 ? -1 : 1;
        try {
            Vec3 a = x.times(mirror / sx);
            Vec3 b = y.times(1 / sy);
            Vec3 c = z.times(1 / sz);
            // Turned about x, then y, then z: the lowest row is −sin y, sin x · cos y, cos x · cos y.
            double aroundY = Math.asin(Math.clamp(-a.z(), -1, 1));
            boolean level = Math.abs(a.z()) < 1 - 1e-12;
            double aroundX = level ? Math.atan2(b.z(), c.z()) : Math.atan2(-c.y(), b.y());
            double aroundZ = level ? Math.atan2(a.y(), a.x()) : 0;
            Vec3 degrees = new Vec3(degrees(aroundX), degrees(aroundY), degrees(aroundZ));
            return Optional.of(new Placement(new Vec3(round(m.t0()), round(m.t1()), round(m.t2())), degrees,
                    new Vec3(mirror * round(sx), round(sy), round(sz))));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private static double degrees(double radians) {
        return round(Math.toDegrees(radians));
    }

    /** To some nine digits: files hold floats, which have seven. */
    private static double round(double v) {
        double nearest = Math.rint(v * 1e9) / 1e9;
        return Math.abs(v) >= 1e-3 && Math.abs(v) < 1e6 ? nearest : Math.abs(v) < 1e-9 ? 0 : v;
    }
}
