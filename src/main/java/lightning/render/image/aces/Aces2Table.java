package lightning.render.image.aces;

import lightning.base.math.ColorLattice;
import lightning.base.math.CurveTable;

/**
 * Output transform of ACES 2 for sRGB displays, tabulated by a {@link ColorLattice} of {@link #POINTS}³ colors. The lattice holds
 * colors before clamping, so that the display's limits do not bend them.
 */
public final class Aces2Table {
    /** Linear gray from which on the transform shows white. */
    public static final double WHITE = Tonescale.ROOF;

    /** Points along an edge of the lattice. */
    private static final int POINTS = 65;
    /** Positions are even steps of (v / (v + 10))^0.3, close to even steps of the display. */
    private static final double HALF = 10;
    private static final double POWER = 0.3;
    private static final double MAX_STEP = step(Aces2.MAX);
    private static final CurveTable POSITION = CurveTable.of(v -> step(Math.min(v, Aces2.MAX)) / MAX_STEP);
    private static final ColorLattice LATTICE =
            new ColorLattice(POINTS, (r, g, b) -> Aces2.encoded(linear(r), linear(g), linear(b)));

    private Aces2Table() {}

    /** Returns the display value, 0 to 1, of a linear gray ≥ 0, by the formula. */
    public static double gray(double v) {
        return Math.clamp(Aces2.encode(Tonescale.display(v)), 0, 1);
    }

    /** Returns red, green and blue for the display, 0 to 1, of a linear color of Rec. 709. NaN counts as 0. */
    public static double[] encoded(float red, float green, float blue) {
        return ColorLattice.values(color(red, green, blue));
    }

    /** Returns the same color in 8 bits per channel, 0xRRGGBB, without creating an object. */
    public static int packed(float red, float green, float blue) {
        return ColorLattice.packed(color(red, green, blue));
    }

    private static long color(float red, float green, float blue) {
        // Colors outside of the lattice are rare.
        return red < 0 || green < 0 || blue < 0 ? ColorLattice.codes(Aces2.encoded(red, green, blue))
                : LATTICE.color(POSITION.value(red), POSITION.value(green), POSITION.value(blue));
    }

    private static double step(double v) {
        return StrictMath.pow(v / (v + HALF), POWER);
    }

    /** Returns the linear value of a channel at a position, 0 to 1. */
    private static double linear(double position) {
        double t = StrictMath.pow(MAX_STEP * position, 1 / POWER);
        return HALF * t / (1 - t);
    }
}
