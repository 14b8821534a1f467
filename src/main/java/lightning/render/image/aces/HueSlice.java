package lightning.render.image.aces;

/**
 * Slice of the display's gamut at one hue, with lightness J from 0 to 100 upward and colorfulness M to the right. Two power curves from
 * black and from white meet in the cusp, the most colorful color.
 *
 * <p>Colors move into the gamut along lines {@code J = axisJ + slope · M}. All lines of a slice have one family: level at black, at white
 * and at the focus, bent toward the focus between them.
 *
 * @param cuspJ      lightness of the cusp
 * @param cuspM      colorfulness of the cusp, moved outward for the {@link #softMin}
 * @param upperPower 1 / γ of the curve from the cusp to white
 * @param reach      largest colorfulness of AP1 at lightness 100
 */
record HueSlice(double cuspJ, double cuspM, double upperPower, double reach) {
    /** J of middle gray on the display. */
    private static final double MIDDLE_J = AppearanceModel.lightnessOfGray(Tonescale.MIDDLE_GRAY);
    private static final double LOWER_POWER = 1 / 1.14;
    private static final double FOCUS_LIMIT = 1.3;
    /** Distance of the lines' focus, in units of white's J. */
    private static final double FOCUS_DISTANCE = 1.35;
    /** Share of the way from the cusp to white from which on the lines get more level. */
    private static final double LEVEL_FROM = 0.3;
    /** Share of the cusp's M over which both curves are blended. */
    private static final double SMOOTHNESS = 0.12;
    /** Factor of the cusp's M, so that the blended curves still contain the gamut. */
    static final double OUTWARD = 1 + 0.27 * SMOOTHNESS;
    /** Share of the boundary within which colors are kept, at least. */
    private static final double KEPT = 0.75;

    HueSlice withUpperPower(double power) {
        return new HueSlice(cuspJ, cuspM, power, reach);
    }

    /** Returns J and M inside the display's gamut. */
    double[] compress(double j, double m) {
        if (j > 100 || m <= 0) {
            return new double[] {j, 0};
        }
        double gain = gain(j);
        double axisJ = axisJ(j, m, gain);
        double slope = slope(axisJ, gain);
        double boundary = boundary(axisJ, slope, gain);
        if (boundary <= 0) {
            return new double[] {j, 0};
        }
        // AP1 has a power curve from black, too, which passes through its reach at white's J.
        double farthest = crossing(axisJ, slope, 100, reach, 1 / AppearanceModel.POWER, 100);
        double moved = remap(m, boundary, farthest);
        return new double[] {axisJ + slope * moved, moved};
    }

    /** Returns J on the boundary, and M, of the line through a point. */
    double[] boundaryPoint(double j, double m) {
        double gain = gain(j);
        double axisJ = axisJ(j, m, gain);
        double slope = slope(axisJ, gain);
        double boundary = boundary(axisJ, slope, gain);
        return new double[] {axisJ + slope * boundary, boundary};
    }

    /** Lightness of the level line in the middle: between the cusp's and middle gray's. */
    private double focus() {
        return lerp(cuspJ, MIDDLE_J, Math.min(1, FOCUS_LIMIT - cuspJ / 100));
    }

    private static double lerp(double a, double b, double t) {
        return a + t * (b - a);
    }

    /** Returns the divisor of slopes; larger near white, so that bright colors become white. */
    private double gain(double j) {
        double gain = 100 * FOCUS_DISTANCE;
        double threshold = lerp(cuspJ, 100, LEVEL_FROM);
        if (j <= threshold) {
            return gain;
        }
        double log = StrictMath.log10((100 - threshold) / Math.max(0.0001, 100 - j));
        return gain * (1 + log * log);
    }

    private double slope(double axisJ, double gain) {
        double focus = focus();
        return (axisJ < focus ? axisJ : 100 - axisJ) * (axisJ - focus) / (focus * gain);
    }

    /** Returns J at M = 0 of the line through a point: a root of a quadratic equation, in the stable form. */
    private double axisJ(double j, double m, double gain) {
        double focus = focus();
        double scaled = m / gain;
        double a = scaled / focus;
        if (j < focus) {
            double b = 1 - scaled;
            return 2 * j / (b + StrictMath.sqrt(b * b + 4 * a * j));
        }
        double b = 1 + scaled + 100 * a;
        double c = 100 * scaled + j;
        return 2 * c / (b + StrictMath.sqrt(b * b - 4 * a * c));
    }

    /** Returns M at which a line leaves the gamut. */
    private double boundary(double axisJ, double slope, double gain) {
        double cuspAxisJ = axisJ(cuspJ, cuspM, gain);
        double lower = crossing(axisJ, slope, cuspJ, cuspM, LOWER_POWER, cuspAxisJ);
        double upper = crossing(100 - axisJ, -slope, 100 - cuspJ, cuspM, upperPower, 100 - cuspAxisJ);
        return softMin(lower, upper, SMOOTHNESS * cuspM);
    }

    /**
     * Returns M at which a line crosses the power curve from (0, 0) to (endJ, endM), approximately: the curve becomes straight and the
     * line's start moves with it; exact at both ends.
     *
     * @param endAxisJ start of the line through the curve's end
     */
    private static double crossing(double axisJ, double slope, double endJ, double endM, double power, double endAxisJ) {
        double start = endAxisJ * StrictMath.pow(axisJ / endAxisJ, power);
        return start * endM / (endJ - slope * endM);
    }

    /** Cubic smooth minimum over a width. */
    private static double softMin(double a, double b, double width) {
        double h = Math.max(width - Math.abs(a - b), 0) / width;
        return Math.min(a, b) - h * h * h * width / 6;
    }

    /** Returns M after a hyperbola that maps {@code farthest} to the boundary and keeps small values. */
    private static double remap(double m, double boundary, double farthest) {
        double share = Math.max(boundary / farthest, KEPT);
        double threshold = share * boundary;
        if (share >= 1 || m <= threshold) {
            return m;
        }
        double inside = boundary - threshold;
        double outside = farthest - threshold;
        double scale = outside * inside / (outside - inside);
        double v = (m - threshold) / scale;
        return threshold + scale * v / (1 + v);
    }
}
