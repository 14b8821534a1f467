package lightning.base.math;

/** sRGB transfer function (IEC 61966-2-1), between encoded values and linear light. */
public final class SrgbCurve {
    private SrgbCurve() {}

    /** Returns the linear value of a sample {@code s} in 0…1: s / 12.92 if s ≤ 0.04045, else ((s + 0.055) / 1.055)<sup>2.4</sup>. */
    public static double toLinear(double s) {
        return s <= 0.04045 ? s / 12.92 : StrictMath.pow((s + 0.055) / 1.055, 2.4);
    }

    /** Returns the sample of a linear value {@code v} in 0…1: 12.92 · v if v ≤ 0.0031308, else 1.055 · v<sup>1/2.4</sup> − 0.055. */
    public static double fromLinear(double v) {
        return v <= 0.0031308 ? 12.92 * v : 1.055 * StrictMath.pow(v, 1 / 2.4) - 0.055;
    }
}
