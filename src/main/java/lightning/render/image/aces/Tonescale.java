package lightning.render.image.aces;

/**
 * Tone curve of ACES 2 from scene luminance to display luminance: a Michaelis-Menten curve with a power for contrast, and a quadratic toe
 * for the flare of the surround. Its constants make middle gray 10 % of the peak, 100 nits, and 128 the scene value that reaches it.
 */
final class Tonescale {
    /** Luminance of middle gray 0.18 on the display before the toe, as a share of the peak. */
    static final double MIDDLE_GRAY = 0.10013;
    private static final double SCENE_GRAY = 0.18;
    /** Power of the curve. */
    private static final double CONTRAST = 1.15;
    private static final double FLARE = 0.04;
    /** Scene luminance shown at the peak. */
    static final double ROOF = 128;

    /** Value before the toe of white and of gray. */
    private static final double WHITE_BEFORE_TOE = beforeToe(1);
    private static final double HALF = half();
    private static final double PEAK = WHITE_BEFORE_TOE / StrictMath.pow(saturation(ROOF, HALF), CONTRAST);

    private Tonescale() {}

    /** Returns the display luminance, 0 to 1, of a scene luminance ≥ 0. */
    static double display(double luminance) {
        double v = PEAK * StrictMath.pow(saturation(luminance, HALF), CONTRAST);
        return v * v / (v + FLARE);
    }

    private static double saturation(double luminance, double half) {
        return luminance / (luminance + half);
    }

    /** Returns the value that the toe maps to {@code v}. */
    private static double beforeToe(double v) {
        return 0.5 * (v + StrictMath.sqrt(v * (v + 4 * FLARE)));
    }

    /** Returns the scene luminance at half saturation for which middle gray is shown as intended, up to the scale of {@link #PEAK}. */
    private static double half() {
        double scale = WHITE_BEFORE_TOE / StrictMath.pow(saturation(ROOF, WHITE_BEFORE_TOE), CONTRAST);
        double share = StrictMath.pow(beforeToe(MIDDLE_GRAY) / scale, 1 / CONTRAST);
        return SCENE_GRAY * (1 - share) / share;
    }
}
