package lightning.base.math;

/** sRGB transfer function (IEC 61966-2-1), from encoded values to linear light. */
public final class SrgbCurve {
    private SrgbCurve() {}

    /** Returns the linear value of a sample {@code s} in 0…1: s / 12.92 if s ≤ 0.04045, else ((s + 0.055) / 1.055)<sup>2.4</sup>. */
    public static double toLinear(double s) {
        return s <= 0.04045 ? s / 12.92 : StrictMath.pow((s + 0.055) / 1.055, 2.4);
    }
}
