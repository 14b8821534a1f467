package lightning.format.exchange.assembly;

import lightning.base.math.Vec3;

/** Numbers of a scene that were computed from floats, without the digits that are only rounding errors. */
public final class NineDigits {
    private NineDigits() {}

    /** Rounds to about nine digits. */
    public static double rounded(double v) {
        double nearest = Math.rint(v * 1e9) / 1e9;
        return Math.abs(v) < 1e6 && (Math.abs(v) >= 1e-3 || nearest == 0) ? nearest + 0.0 : v;
    }

    public static Vec3 rounded(Vec3 v) {
        return new Vec3(rounded(v.x()), rounded(v.y()), rounded(v.z()));
    }
}
