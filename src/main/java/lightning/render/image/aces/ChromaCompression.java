package lightning.render.image.aces;

/** Colorfulness after the tone curve: it is scaled with lightness, expanded in shadows and middle tones, and compressed in highlights. */
final class ChromaCompression {
    private static final double EXPANSION = 1.3;
    private static final double EXPANSION_THRESHOLD = 0.5 / 100;
    private static final double COMPRESSION = 2.4;
    /** Keeps the inner limit of the expansion below the outer one. */
    private static final double MARGIN = 0.001;
    /** Size of the AP1 gamut for a peak of 100 nits. */
    private static final double SIZE = StrictMath.pow(0.03379 * 100, 0.30596) - 0.45135;

    private ChromaCompression() {}

    /**
     * Returns the new colorfulness.
     *
     * @param m      colorfulness before
     * @param j      lightness before and after the tone curve
     * @param reach  largest M of AP1 at this hue and lightness 100
     * @param cosine of the hue, with {@code sine}
     */
    static double compress(double m, double j, double toned, double reach, double cosine, double sine) {
        double share = toned / 100;
        double rest = Math.max(0, 1 - share);
        double cusp = cusp(cosine, sine);
        double limit = StrictMath.pow(share, 1 / AppearanceModel.POWER) * reach / cusp;
        double v = m * StrictMath.pow(toned / j, 1 / AppearanceModel.POWER) / cusp;
        v = limit - toe(limit - v, limit - MARGIN, rest * EXPANSION, StrictMath.sqrt(share * share + EXPANSION_THRESHOLD));
        return cusp * toe(v, limit, share * COMPRESSION, rest);
    }

    /** Returns the published fit of the largest colorfulness in AP1 at a hue. */
    private static double cusp(double cosine, double sine) {
        double cosine2 = 2 * cosine * cosine - 1;
        double sine2 = 2 * sine * cosine;
        double cosine3 = cosine * (2 * cosine2 - 1);
        double sine3 = sine * (2 * cosine2 + 1);
        return SIZE * (77.12896 + 11.34072 * cosine + 16.46899 * cosine2 + 7.88380 * cosine3
                + 14.66441 * sine - 6.37224 * sine2 + 9.19364 * sine3);
    }

    /** Returns a rising curve from 0 at 0 to {@code limit} at {@code limit}, flat at first; values above the limit are kept. */
    private static double toe(double x, double limit, double strength, double width) {
        if (x > limit) {
            return x;
        }
        double k2 = Math.max(width, 0.001);
        double k1 = StrictMath.sqrt(strength * strength + k2 * k2);
        double k3 = (limit + k1) / (limit + k2);
        double b = k3 * x - k1;
        return 0.5 * (b + StrictMath.sqrt(b * b + 4 * k2 * k3 * x));
    }
}
