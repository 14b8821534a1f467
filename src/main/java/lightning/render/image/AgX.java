package lightning.render.image;

import lightning.base.math.ColorLattice;
import lightning.base.math.CurveTable;
import lightning.base.math.Matrix3;
import lightning.base.math.Primaries;
import lightning.base.math.SrgbCurve;

/**
 * AgX view transform for sRGB displays as Blender has it since version 4.0: Sobotka's AgX (github.com/sobotka/AgX, 2022) in the form of
 * Zhou, Faderbauer and Kapanen (github.com/EaryChow/AgX_LUT_Gen, 2023). Bright colors become white almost without a change of hue.
 *
 * <ol>
 * <li>Colors outside of Rec. 2020 are moved into it.
 * <li>Inset: the primaries of Rec. 2020 are turned and moved toward white.
 * <li>Curve: Smith's sigmoid of the logarithm, with slope 2.4 at middle gray, which stays 0.18, and powers of 1.5. Above 6.5 stops it goes
 * on beyond 1.
 * <li>Hue: the middle channel keeps {@link #KEPT_HUE 60 %} of its place between the others from before the curve.
 * <li>Outset: colors move away from gray, and those outside of Rec. 709 are moved into it.
 * </ol>
 *
 * <p>Blender tabulates this at {@link #POINTS}³ points, evenly spaced in the logarithm of FilmLight's E-Gamut, encodes colors by a power of
 * 2.4, and interpolates tetrahedrally; so does this class. It has Blender's lattice within 10⁻⁴, computed from the formulas.
 */
final class AgX {
    private static final int POINTS = 57;
    private static final Log2Shaper LOG = new Log2Shaper(-10, 15);
    /** Stops above and below middle gray between which the sigmoid rises from 0 to 1. */
    private static final Log2Shaper SIGMOID = new Log2Shaper(-10, 6.5);
    /** Linear gray from which on the curve is white. */
    static final double WHITE = SIGMOID.white();

    private static final Primaries REC2020 =
            new Primaries(new double[] {0.708, 0.292, 0.17, 0.797, 0.131, 0.046}, Primaries.REC709.white());
    /** Published in FilmLight, T-Cam Colour Space, 2018. */
    private static final Primaries E_GAMUT =
            new Primaries(new double[] {0.8, 0.3177, 0.18, 0.9, 0.065, -0.0805}, Primaries.REC709.white());
    private static final double[] TO_E_GAMUT = Primaries.REC709.to(E_GAMUT).m();
    private static final Matrix3 TO_REC2020 = E_GAMUT.to(REC2020);
    private static final Matrix3 TO_REC709 = REC2020.to(Primaries.REC709);

    /** Shares of Rec. 2020's primaries in the luminance of CIE 2015. */
    private static final double[] LUMINANCE_2020 = {0.2658180370250449, 0.59846986045365, 0.1357121025213052};
    private static final double[] LUMINANCE_709 = rowTimes(LUMINANCE_2020, Primaries.REC709.to(REC2020));
    /** Turned by 2.14°, −1.23° and −3.05°, and moved by 33, 28 and 12 % of the distance to white. */
    private static final Matrix3 INSET = Matrix3.of(0.856627153315983, 0.0951212405381588, 0.0482516061458583,
            0.137318972929847, 0.761241990602591, 0.101439036467562, 0.11189821299995, 0.0767994186031903, 0.811302368396859);
    /** A color that the outset leaves unchanged is {@code c · k + gray}, with k = 1 − the sum of these shares of the channels in gray. */
    private static final double[] OUTSET = {0.11142098895748, 0.0871996192028349, 0.0130034248855548};
    private static final double OUTSET_SUM = OUTSET[0] + OUTSET[1] + OUTSET[2];
    private static final double KEPT_HUE = 0.6;

    private static final double PIVOT_X = SIGMOID.encode(Log2Shaper.MIDDLE_GRAY);
    /** Exponent of the encoding of the lattice. */
    private static final double GAMMA = 2.4;
    private static final double PIVOT_Y = StrictMath.pow(Log2Shaper.MIDDLE_GRAY, 1 / GAMMA);
    private static final double SLOPE = 2.4;
    private static final double POWER = 1.5;
    private static final double TOE_SCALE = scale(PIVOT_X, PIVOT_Y);
    private static final double SHOULDER_SCALE = scale(1 - PIVOT_X, 1 - PIVOT_Y);

    private static final CurveTable POSITION = CurveTable.of(LOG::encode);
    private static final ColorLattice LATTICE = new ColorLattice(POINTS, (r, g, b) -> encoded(LOG.decode(r), LOG.decode(g), LOG.decode(b)));
    private static final CurveTable DISPLAY = CurveTable.of(AgX::display);

    private AgX() {}

    /** Returns the display value, 0 to 1, of a linear gray ≥ 0, by the formula. */
    static double gray(double v) {
        return display(Math.min(sigmoid(Log2Shaper.stops(v)), 1));
    }

    /** Returns red, green and blue for the display, 0 to 1, of a finite linear color of Rec. 709. */
    static double[] display(double red, double green, double blue) {
        return ColorLattice.values(color(red, green, blue), DISPLAY);
    }

    /** Returns the same color in 8 bits per channel, 0xRRGGBB, without creating an object. */
    static int packed(double red, double green, double blue) {
        return ColorLattice.packed(color(red, green, blue), DISPLAY);
    }

    private static long color(double r, double g, double b) {
        double[] m = TO_E_GAMUT;
        // Sums of differences keep grays gray in every bit.
        return LATTICE.color(POSITION.value((float) (r + m[1] * (g - r) + m[2] * (b - r))),
                POSITION.value((float) (g + m[3] * (r - g) + m[5] * (b - g))),
                POSITION.value((float) (b + m[6] * (r - b) + m[7] * (g - b))));
    }

    /** Returns the color of Rec. 709 for a linear color of E-Gamut, encoded by a power, 0 to 1. */
    private static double[] encoded(double red, double green, double blue) {
        double[] c = TO_REC2020.times(red, green, blue);
        double luminance = dot(LUMINANCE_2020, c);
        double outside = -min(c);
        if (outside > 0) {
            move(c, outside, (2 * luminance + outside) / (2 * luminance + 2 * outside));
        }
        c = formed(INSET.times(c));
        double gray = dot(OUTSET, c) / OUTSET_SUM;
        for (int i = 0; i < 3; i++) {
            c[i] = gray + (c[i] - gray) / (1 - OUTSET_SUM);
        }
        c = TO_REC709.times(c);
        intoRec709(c);
        for (int i = 0; i < 3; i++) {
            c[i] = StrictMath.pow(Math.clamp(c[i], 0, 1), 1 / GAMMA);
        }
        return c;
    }

    /** Applies the curve to each channel, and restores a part of the hue. */
    private static double[] formed(double[] c) {
        double[] curved = new double[3];
        int max = 0;
        int min = 0;
        for (int i = 0; i < 3; i++) {
            curved[i] = StrictMath.pow(sigmoid(Log2Shaper.stops(c[i])), GAMMA);
            max = c[i] > c[max] ? i : max;
            min = c[i] <= c[min] ? i : min;
        }
        int middle = 3 - max - min;
        if (curved[max] > curved[min]) {
            double before = (c[middle] - c[min]) / (c[max] - c[min]);
            double after = (curved[middle] - curved[min]) / (curved[max] - curved[min]);
            curved[middle] = curved[min] + (after + KEPT_HUE * (before - after)) * (curved[max] - curved[min]);
        }
        return curved;
    }

    private static void intoRec709(double[] c) {
        double outside = -min(c);
        if (outside > 0) {
            double luminance = dot(LUMINANCE_709, c);
            double moved = luminance + outside;
            double target = luminance + shadow(luminance) * (luminance + outside);
            move(c, outside, Math.min(1, target / (moved * (1 + shadow(moved)))));
        }
    }

    /** Returns 1 at black, falling to 0 at white. */
    private static double shadow(double luminance) {
        return 1 - Math.min(StrictMath.pow(Math.max(luminance, 0), 0.08), 1);
    }

    private static void move(double[] c, double offset, double factor) {
        for (int i = 0; i < 3; i++) {
            c[i] = (c[i] + offset) * factor;
        }
    }

    private static double min(double[] c) {
        return Math.min(c[0], Math.min(c[1], c[2]));
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] rowTimes(double[] row, Matrix3 matrix) {
        double[] m = matrix.m();
        return new double[] {dot(row, new double[] {m[0], m[3], m[6]}), dot(row, new double[] {m[1], m[4], m[7]}),
            dot(row, new double[] {m[2], m[5], m[8]})};
    }

    /** Returns the display value of an encoded one. */
    private static double display(double encoded) {
        return SrgbCurve.fromLinear(StrictMath.pow(encoded, GAMMA));
    }

    /** Returns the sigmoid of a number of stops from middle gray: 0 at −10, 1 at 6.5. */
    private static double sigmoid(double stops) {
        double x = Math.max((stops - SIGMOID.min()) / (SIGMOID.max() - SIGMOID.min()), 0);
        return x < PIVOT_X ? Math.max(PIVOT_Y - rise(PIVOT_X - x, TOE_SCALE), 0) : PIVOT_Y + rise(x - PIVOT_X, SHOULDER_SCALE);
    }

    /** Returns the distance from the pivot's value at a distance from the pivot; straight at first, then less and less steep. */
    private static double rise(double distance, double scale) {
        double t = SLOPE * distance / scale;
        return scale * t / StrictMath.pow(1 + StrictMath.pow(t, POWER), 1 / POWER);
    }

    /** Returns the scale for which {@link #rise} is {@code height} at {@code width}. */
    private static double scale(double width, double height) {
        double straight = SLOPE * width;
        return straight / StrictMath.pow(StrictMath.pow(straight / height, POWER) - 1, 1 / POWER);
    }
}
