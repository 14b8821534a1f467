package lightning.format.pov;

import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/** Formats values in POV-Ray syntax, with full precision. */
final class PovFormat {
    private PovFormat() {}

    static String vector(Vec3 v) {
        return vector(v.x(), v.y(), v.z());
    }

    static String rgb(Rgb c) {
        return "rgb " + vector(c.r(), c.g(), c.b());
    }

    private static String vector(double x, double y, double z) {
        return "<" + x + ", " + y + ", " + z + ">";
    }

    /** Formats a transform; POV-Ray multiplies row vectors from the left, so its rows are our columns. */
    static String matrix(Transform m) {
        return "matrix <" + m.m00() + ", " + m.m10() + ", " + m.m20() + ", "
                + m.m01() + ", " + m.m11() + ", " + m.m21() + ", "
                + m.m02() + ", " + m.m12() + ", " + m.m22() + ", "
                + m.t0() + ", " + m.t1() + ", " + m.t2() + ">";
    }
}
