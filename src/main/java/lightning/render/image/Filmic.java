package lightning.render.image;

import lightning.base.math.ColorLattice;
import lightning.base.math.CurveTable;

/**
 * Filmic view transform for sRGB displays, as Blender has it (Sobotka, github.com/sobotka/filmic-blender, 2017), with medium contrast.
 *
 * <ol>
 * <li>Desaturation: from 6 stops above middle gray on, the darker channels of a color move toward its brightest one, and meet it at 15 stops.
 * <li>Curve of the logarithm of each channel: −10 to 6.5 stops around middle gray 0.18 become 0 to 1, and middle gray 0.5.
 * </ol>
 *
 * <p>Only the range of the logarithm is published. The formulas of both steps are fits to what Blender shows: within 10⁻⁵ for the desaturation,
 * and 0.12 of 255 for the curve. Blender tabulates the desaturation at {@link #POINTS}³ points, evenly spaced in the logarithm, and interpolates
 * tetrahedrally; so does this class.
 */
final class Filmic {
    private static final int POINTS = 33;
    private static final Log2Shaper LOG = new Log2Shaper(-10, 15);
    private static final Log2Shaper CURVE = new Log2Shaper(-10, 6.5);
    /** Linear gray from which on the curve is white. */
    static final double WHITE = CURVE.white();

    private static final double DESATURATED_FROM = Log2Shaper.MIDDLE_GRAY * 64;
    private static final double DESATURATED_TO = LOG.white();
    private static final double DESATURATION_POWER = 1.1;
    /** Largest value of the last point of the lattice before the desaturation: channels up to it are shown independently. */
    static final float MAX_INDEPENDENT = (float) LOG.decode(20.0 / (POINTS - 1));

    private static final double PIVOT = CURVE.encode(Log2Shaper.MIDDLE_GRAY);
    private static final double TOE_STEEPNESS = 8.4964;
    private static final double TOE_CENTER = 0.6322;
    private static final double TOE_POWER = 0.9376;
    private static final double SHOULDER_STEEPNESS = 5.6027;
    private static final double SHOULDER_CENTER = 0.15246;
    private static final double SHOULDER_POWER = 3.8234;

    private static final CurveTable POSITION = CurveTable.of(LOG::encode);
    private static final ColorLattice LATTICE = new ColorLattice(POINTS, Filmic::desaturated);
    private static final CurveTable DISPLAY = CurveTable.of(Filmic::display);

    private Filmic() {}

    /** Returns the display value, 0 to 1, of a linear gray ≥ 0, by the formula. */
    static double gray(double v) {
        return curve(CURVE.encode(v));
    }

    /** Returns whether each channel of a color is shown as a gray of its value. */
    static boolean isIndependent(float red, float green, float blue) {
        // NaN counts as 0.
        return !(red > MAX_INDEPENDENT) && !(green > MAX_INDEPENDENT) && !(blue > MAX_INDEPENDENT);
    }

    /** Returns red, green and blue for the display, 0 to 1, of a linear color of Rec. 709. */
    static double[] display(float red, float green, float blue) {
        return ColorLattice.values(color(red, green, blue), DISPLAY);
    }

    /** Returns the same color in 8 bits per channel, 0xRRGGBB, without creating an object. */
    static int packed(float red, float green, float blue) {
        return ColorLattice.packed(color(red, green, blue), DISPLAY);
    }

    private static long color(float red, float green, float blue) {
        return LATTICE.color(POSITION.value(red), POSITION.value(green), POSITION.value(blue));
    }

    private static double[] desaturated(double... position) {
        double max = LOG.decode(Math.max(position[0], Math.max(position[1], position[2])));
        if (max <= DESATURATED_FROM) {
            return position;
        }
        double share = StrictMath.pow((max - DESATURATED_FROM) / (DESATURATED_TO - DESATURATED_FROM), DESATURATION_POWER);
        double[] color = new double[3];
        for (int c = 0; c < 3; c++) {
            double v = LOG.decode(position[c]);
            color[c] = LOG.encode(v + share * (max - v));
        }
        return color;
    }

    /** Returns the display value at a position in the lattice. */
    private static double display(double position) {
        return curve(Math.min(position * (LOG.max() - LOG.min()) / (CURVE.max() - CURVE.min()), 1));
    }

    /** Returns the display value of a logarithm, 0 to 1. */
    private static double curve(double x) {
        return x < PIVOT ? rise(x, PIVOT, TOE_STEEPNESS, TOE_CENTER, TOE_POWER)
                : 1 - rise(1 - x, 1 - PIVOT, SHOULDER_STEEPNESS, SHOULDER_CENTER, SHOULDER_POWER);
    }

    /** Returns a power of a logistic curve, scaled so that it is 0 at 0 and 0.5 at {@code end}. */
    private static double rise(double x, double end, double steepness, double center, double power) {
        double start = logistic(0, steepness, center, power);
        return 0.5 * (logistic(x, steepness, center, power) - start) / (logistic(end, steepness, center, power) - start);
    }

    private static double logistic(double x, double steepness, double center, double power) {
        return StrictMath.pow(1 + StrictMath.exp(steepness * (center - x)), -power);
    }
}
