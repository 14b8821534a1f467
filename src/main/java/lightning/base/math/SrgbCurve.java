package lightning.base.math;

/** The curve of sRGB (IEC 61966-2-1), from what files hold to light. */
public final class SrgbCurve {
    private SrgbCurve() {}

    /**
     * The linear value of a sample {@code s} in 0…1: s / 12.92 where s ≤ 0.04045, else ((s + 0.055) / 1.055)<sup>2.4</sup>.
     */
    public static double toLinear(double s) {
        return s <= 0.04045 ? s / 12.92 : StrictMath.pow((s + 0.055) / 1.055, 2.4);
    }
}
