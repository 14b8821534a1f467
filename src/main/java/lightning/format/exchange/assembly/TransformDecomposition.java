package lightning.format.exchange.assembly;

import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.scene.value.Placement;

/** Decomposition of affine transforms into placements: scale, then rotate about x, y and z, then translate. */
public final class TransformDecomposition {
    /**
     * Cosine of the angle between two axes above which a transform counts as sheared; rounding to float leaves less than
     * 1e-6.
     */
    private static final double MAX_SHEAR_COSINE = 1e-5;
    /**
     * Number of Jacobi sweeps. Each squares the residual, so this is ample; a transform that still shears cannot be
     * decomposed.
     */
    private static final int JACOBI_SWEEPS = 10;

    private TransformDecomposition() {}

    /**
     * Returns placements whose product is the transform, outermost first: one, or two if it shears, since every linear map
     * is a rotation, a scaling and another rotation. Empty if it is flat in any direction or exceeds a scene's limits.
     */
    public static List<Placement> decompose(Transform m) {
        try {
            if (!hasShear(m)) {
                return List.of(placement(m));
            }
            Transform rotation = orthogonalizingRotation(m);
            Transform rotated = m.times(rotation);
            return hasShear(rotated) ? List.of() : List.of(placement(rotated), placement(rotation.transposed()));
        } catch (RefusalException e) {
            return List.of();
        }
    }

    private static boolean hasShear(Transform m) {
        Vec3 x = column(m, 0);
        Vec3 y = column(m, 1);
        Vec3 z = column(m, 2);
        return !(cosine(x, y) <= MAX_SHEAR_COSINE && cosine(y, z) <= MAX_SHEAR_COSINE && cosine(z, x) <= MAX_SHEAR_COSINE);
    }

    private static double cosine(Vec3 a, Vec3 b) {
        return Math.abs(a.dot(b)) / (a.length() * b.length());
    }

    private static Vec3 column(Transform m, int axis) {
        return m.transformVector(new Vec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0));
    }

    /**
     * Returns a rotation after which the transform's axes are orthogonal, by rotating pairs of axes in their plane (Hestenes
     * 1958, Inversion of matrices by biorthogonalization).
     */
    private static Transform orthogonalizingRotation(Transform m) {
        Transform rotation = Transform.IDENTITY;
        for (int sweep = 0; sweep < JACOBI_SWEEPS; sweep++) {
            for (int p = 0; p < 3; p++) {
                int q = (p + 1) % 3;
                Transform rotated = m.times(rotation);
                Vec3 a = column(rotated, p);
                Vec3 b = column(rotated, q);
                // Use the smaller of the two possible rotations: the larger one would swap the axes in every sweep.
                double difference = a.dot(a) - b.dot(b);
                double angle = Math.toDegrees(Math.atan2(difference < 0 ? -2 * a.dot(b) : 2 * a.dot(b), Math.abs(difference)) / 2);
                // About the third axis, from p toward q.
                rotation = rotation.times(Transform.rotation(new Vec3(p == 1 ? angle : 0, p == 2 ? angle : 0, p == 0 ? angle : 0)));
            }
        }
        return rotation;
    }

    private static Placement placement(Transform m) {
        Vec3 x = column(m, 0);
        Vec3 y = column(m, 1);
        Vec3 z = column(m, 2);
        double sx = x.length();
        double sy = y.length();
        double sz = z.length();
        // Treat a reflection as a negative scale along x.
        double mirror = x.cross(y).dot(z) < 0 ? -1 : 1;
        Vec3 a = x.times(mirror / sx);
        Vec3 b = y.times(1 / sy);
        Vec3 c = z.times(1 / sz);
        // Rotation about x, then y, then z: the first column is cos y · cos z, cos y · sin z, −sin y. If it points along z,
        // the angle about z is arbitrary and determines that about x. Angles are never computed from a sine or cosine near
        // 1, which would be ill-conditioned.
        double aroundY = Math.atan2(-a.z(), Math.hypot(a.x(), a.y()));
        double aroundZ = Math.atan2(a.y(), a.x());
        double sin = Math.sin(aroundZ);
        double cos = Math.cos(aroundZ);
        double aroundX = Math.atan2(sin * c.x() - cos * c.y(), cos * b.y() - sin * b.x());
        return new Placement(new Vec3(round(m.t0()), round(m.t1()), round(m.t2())),
                new Vec3(degrees(aroundX), degrees(aroundY), degrees(aroundZ)), new Vec3(mirror * round(sx), round(sy), round(sz)));
    }

    private static double degrees(double radians) {
        return round(Math.toDegrees(radians));
    }

    /** Rounds to about nine digits; floats in files have seven. */
    private static double round(double v) {
        double nearest = Math.rint(v * 1e9) / 1e9;
        return Math.abs(v) >= 1e-3 && Math.abs(v) < 1e6 ? nearest : Math.abs(v) < 1e-9 ? 0 : v;
    }
}
