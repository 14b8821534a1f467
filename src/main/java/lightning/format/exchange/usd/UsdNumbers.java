package lightning.format.exchange.usd;

import lightning.base.math.Vec3;
import lightning.format.exchange.assembly.NineDigits;

/** Numbers of a scene for those of a stage, which are floats. */
final class UsdNumbers {
    private UsdNumbers() {}

    /** Returns the shortest decimal number that is the same float. */
    static double tidy(double v) {
        return v == (float) v ? Double.parseDouble(Float.toString((float) v)) : rounded(v);
    }

    static Vec3 rounded(Vec3 v) {
        return NineDigits.rounded(v);
    }

    /** Rounds to about nine digits. */
    static double rounded(double v) {
        return NineDigits.rounded(v);
    }
}
