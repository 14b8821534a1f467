package lightning.scene.value;

import lightning.base.math.CieXyz;
import lightning.base.math.Rgb;

/**
 * Conversion between black-body temperatures and linear sRGB colors (IEC 61966-2-1, white D65). Uses the cubic fit of the Planckian locus
 * by Kim et al. (US patent 7024034).
 */
public final class ColorTemperature {
    public static final double MIN = 1667;
    public static final double MAX = 25000;
    /** Temperature that keeps a light's color: that of white, D65. */
    public static final double NEUTRAL = 6500;
    private static final double LOCUS_SPLIT = 4000;
    private static final double LOW_SPLIT = 2222;

    private ColorTemperature() {}

    /**
     * Returns the color, scaled so that the brightest channel is 1. Clamps channels outside the gamut to 0.
     *
     * @param kelvin 1667…25000
     * @throws IllegalArgumentException if {@code kelvin} is out of range
     */
    public static Rgb rgb(double kelvin) {
        SceneLimits.checkRange("temperature", kelvin, MIN, MAX);
        double x = chromaticityX(kelvin);
        double y = chromaticityY(kelvin, x);
        Rgb mixed = CieXyz.rgb(x / y, 1, (1 - x - y) / y);
        double max = mixed.max();
        return new Rgb(mixed.r() / max, mixed.g() / max, mixed.b() / max);
    }

    /**
     * Returns the color that multiplies that of a light of a temperature: relative to {@link #NEUTRAL}, whose tint is exactly white, and
     * with the luminance of white (Rec. 709), so that a temperature does not change the brightness.
     *
     * @param kelvin 1667…25000
     * @throws IllegalArgumentException if {@code kelvin} is out of range
     */
    public static Rgb tint(double kelvin) {
        if (kelvin == NEUTRAL) {
            return Rgb.WHITE;
        }
        Rgb color = rgb(kelvin);
        Rgb white = rgb(NEUTRAL);
        Rgb relative = new Rgb(color.r() / white.r(), color.g() / white.g(), color.b() / white.b());
        return relative.times(1 / (0.2126 * relative.r() + 0.7152 * relative.g() + 0.0722 * relative.b()));
    }

    /**
     * Returns the temperature whose color has the same ratio of blue to red, which increases monotonically along the locus. Clamps to the
     * nearest end of the range.
     *
     * @param color linear, channels ≥ 0
     */
    public static double of(Rgb color) {
        double low = MIN;
        double high = MAX;
        for (int i = 0; i < 60; i++) {
            double mid = (low + high) / 2;
            Rgb candidate = rgb(mid);
            if (candidate.b() * color.r() < color.b() * candidate.r()) {
                low = mid;
            } else {
                high = mid;
            }
        }
        return low;
    }

    static double chromaticityX(double t) {
        return t <= LOCUS_SPLIT
                ? ((-0.2661239e9 / t - 0.2343589e6) / t + 0.8776956e3) / t + 0.179910
                : ((-3.0258469e9 / t + 2.1070379e6) / t + 0.2226347e3) / t + 0.240390;
    }

    static double chromaticityY(double t, double x) {
        if (t <= LOW_SPLIT) {
            return ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
        }
        return t <= LOCUS_SPLIT
                ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    }
}
