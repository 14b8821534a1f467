package lightning.render.image.aces;

import lightning.base.math.Matrix3;
import lightning.base.math.Primaries;

/**
 * Color appearance model of ACES 2: lightness J (0 black, 100 white), colorfulness M ≥ 0 and hue h in degrees of an RGB color.
 *
 * <p>Hellwig and Fairchild, Brightness, lightness, colorfulness, and chroma in CIECAM02 and CAM16 (Color Research and Application 47(5),
 * 2022), simplified by ACES 2: the eye is adapted to white completely, cone responses are symmetric around 0 without the offset of 0.1,
 * and the cone space has the primaries below.
 */
final class AppearanceModel {
    /** Cone space of CAM16 as RGB primaries, with the ACES constants. */
    private static final Primaries CONES =
            new Primaries(new double[] {0.8336, 0.1735, 2.3854, -1.4659, 0.087, -0.125}, new double[] {0.333, 0.333});
    /** Luminance of the adapting field, cd/m², that of its background and of white. */
    private static final double ADAPTING = 100;
    private static final double BACKGROUND = 20;
    private static final double WHITE = 100;
    /** Dim surround. */
    private static final double IMPACT = 0.59;
    private static final double INDUCTION = 0.9;
    /** Factor of a and b in the model. */
    private static final double COLORFULNESS = 43;
    private static final double RESPONSE_POWER = 0.42;
    private static final double RESPONSE_SCALE = 400;
    private static final double SEMI_SATURATION = 27.13;
    /** Largest cone response that is inverted, as a share of the limit. */
    private static final double MAX_RESPONSE = 0.99;

    /** Power from the achromatic response to J, the model's c · z. */
    static final double POWER = IMPACT * (1.48 + StrictMath.sqrt(BACKGROUND / WHITE));
    /** Adapted cone response of white, the model's F_L. */
    private static final double ADAPTATION = adaptation();
    private static final double WHITE_RESPONSE = response(ADAPTATION);
    /** From three cone responses to 2r + g + b/20, and the opponent axes a and b. */
    private static final Matrix3 OPPONENTS =
            Matrix3.of(2, 1, 1 / 20.0, 1, -12 / 11.0, 1 / 11.0, 1 / 9.0, 1 / 9.0, -2 / 9.0)
                    .scaleRows(1 / (3.05 * WHITE_RESPONSE), opponentScale(), opponentScale());
    private static final Matrix3 FROM_OPPONENTS = OPPONENTS.inverse();

    private final Matrix3 toCones;
    private final Matrix3 fromCones;

    AppearanceModel(Primaries primaries) {
        Matrix3 cones = CONES.toXyz().inverse().after(primaries.toXyz());
        double[] white = cones.times(1, 1, 1);
        toCones = cones.scaleRows(ADAPTATION / white[0], ADAPTATION / white[1], ADAPTATION / white[2]);
        fromCones = toCones.inverse();
    }

    private static double adaptation() {
        double k = 1 / (5 * ADAPTING + 1);
        double k4 = k * k * k * k;
        return 0.2 * k4 * 5 * ADAPTING + 0.1 * (1 - k4) * (1 - k4) * StrictMath.cbrt(5 * ADAPTING);
    }

    private static double opponentScale() {
        return RESPONSE_SCALE * COLORFULNESS * INDUCTION;
    }

    /** Returns the achromatic response (0 black, 1 white), a and b of a color. */
    double[] opponents(double... rgb) {
        double[] cone = toCones.times(rgb);
        return OPPONENTS.times(response(cone[0]), response(cone[1]), response(cone[2]));
    }

    /** Returns J, M and h of the response, a and b. */
    static double[] correlates(double[] opponents) {
        if (!(opponents[0] > 0)) {
            return new double[3];
        }
        double hue = StrictMath.toDegrees(StrictMath.atan2(opponents[2], opponents[1]));
        return new double[] {lightness(opponents[0]), StrictMath.hypot(opponents[1], opponents[2]), hue < 0 ? hue + 360 : hue};
    }

    /** Returns J, M and h of a color. */
    double[] jmh(double... rgb) {
        return correlates(opponents(rgb));
    }

    /** Returns the color of J, M and h. */
    double[] rgb(double j, double m, double hue) {
        double angle = StrictMath.toRadians(hue);
        double[] cone = FROM_OPPONENTS.times(StrictMath.pow(j / 100, 1 / POWER), m * StrictMath.cos(angle), m * StrictMath.sin(angle));
        return fromCones.times(stimulus(cone[0]), stimulus(cone[1]), stimulus(cone[2]));
    }

    /** Returns J of an achromatic response ≥ 0. */
    private static double lightness(double response) {
        return 100 * StrictMath.pow(response, POWER);
    }

    /** Returns J of a gray with a luminance ≥ 0; 1 is white. */
    static double lightnessOfGray(double luminance) {
        return lightness(response(ADAPTATION * luminance) / WHITE_RESPONSE);
    }

    /** Returns the luminance of the gray with an achromatic response. */
    static double luminanceOfGray(double response) {
        return stimulus(response * WHITE_RESPONSE) / ADAPTATION;
    }

    /** Returns the compressed response of a cone, as a share of the limit (Naka and Rushton). */
    private static double response(double stimulus) {
        double v = StrictMath.pow(Math.abs(stimulus), RESPONSE_POWER);
        return Math.copySign(v / (SEMI_SATURATION + v), stimulus);
    }

    /** Returns the stimulus of a {@link #response}. */
    private static double stimulus(double response) {
        double share = Math.min(Math.abs(response), MAX_RESPONSE);
        return Math.copySign(StrictMath.pow(SEMI_SATURATION * share / (1 - share), 1 / RESPONSE_POWER), response);
    }
}
