package lightning.format.exchange.usd;

import lightning.base.math.Vec3;

/** Numbers of a scene for those of a stage, which are floats. */
final class UsdNumbers {
    private UsdNumbers() {}

    /** Returns the shortest decimal number that is the same float. */
    static double tidy(double v) {
        return v == (float) v ? Double.parseDouble(Float.toString((float) v)) : rounded(v);
    }

    static Vec3 rounded(Vec3 v) {
        return new Vec3(rounded(v.x()), rounded(v.y()), rounded(v.z()));
    }

    /** Rounds to about nine digits. */
    static double rounded(double v) {
        double nearest = Math.rint(v * 1e9) / 1e9;
        return Math.abs(v) < 1e6 && (Math.abs(v) >= 1e-3 || nearest == 0) ? nearest + 0.0 : v;
    }
}
