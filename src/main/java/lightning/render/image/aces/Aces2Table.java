package lightning.render.image.aces;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import lightning.base.math.CurveTable;

/**
 * Output transform of ACES 2 for sRGB displays, tabulated: a lattice of {@link #POINTS}³ colors, interpolated tetrahedrally.
 *
 * <p>Points are computed by {@link Aces2} when a color next to them is shown for the first time, because a picture needs few of them. The
 * lattice holds colors before clamping, so that the display's limits do not bend them.
 */
public final class Aces2Table {
    /** Linear gray from which on the transform shows white. */
    public static final double WHITE = Tonescale.ROOF;

    /** Points along an edge of the lattice. */
    private static final int POINTS = 65;
    private static final int LAST = POINTS - 1;
    /** Positions are even steps of (v / (v + 10))^0.3, close to even steps of the display. */
    private static final double HALF = 10;
    private static final double POWER = 0.3;
    private static final double MAX_STEP = step(Aces2.MAX);
    private static final CurveTable POSITION = CurveTable.of(v -> step(Math.min(v, Aces2.MAX)) / MAX_STEP);

    private static final int ALONG_RED = 1;
    private static final int ALONG_GREEN = POINTS;
    private static final int ALONG_BLUE = POINTS * POINTS;

    /** Bits of a channel's code. */
    private static final int BITS = 21;
    private static final long MASK = (1L << BITS) - 1;
    /** Code of 0, and difference to that of 1: from −0.5 to 1.5. Codes are above 0, so that 0 is a point not computed yet. */
    private static final long ZERO = 1L << BITS - 2;
    private static final long ONE = 1L << BITS - 1;

    private static final long[] LATTICE = new long[POINTS * POINTS * POINTS];
    /** Threads may compute a point twice; each write is atomic and writes the same bits. */
    private static final VarHandle POINT = MethodHandles.arrayElementVarHandle(long[].class);

    private Aces2Table() {}

    /** Returns the display value, 0 to 1, of a linear gray ≥ 0, by the formula. */
    public static double gray(double v) {
        return Math.clamp(Aces2.encode(Tonescale.display(v)), 0, 1);
    }

    /** Returns red, green and blue for the display, 0 to 1, of a linear color of Rec. 709. NaN counts as 0. */
    public static double[] encoded(float red, float green, float blue) {
        long color = color(red, green, blue);
        return new double[] {value(color), value(color >>> BITS), value(color >>> 2 * BITS)};
    }

    /** Returns the same color in 8 bits per channel, 0xRRGGBB, without creating an object. */
    public static int packed(float red, float green, float blue) {
        long color = color(red, green, blue);
        return code8(color) << 16 | code8(color >>> BITS) << 8 | code8(color >>> 2 * BITS);
    }

    private static double value(long color) {
        return Math.clamp((color & MASK) - ZERO, 0, ONE) / (double) ONE;
    }

    private static int code8(long color) {
        return (int) (Math.clamp((color & MASK) - ZERO, 0, ONE) * 255 + ONE / 2 >> BITS - 1);
    }

    /** Returns the codes of a display color in the lowest bits, red first. */
    private static long color(float red, float green, float blue) {
        // Colors outside of the lattice are rare.
        return red < 0 || green < 0 || blue < 0 ? codes(red, green, blue)
                : interpolated(LAST * POSITION.value(red), LAST * POSITION.value(green), LAST * POSITION.value(blue));
    }

    /** Interpolates from a corner of the cell along the axes, the largest fraction first, to the opposite corner. */
    private static long interpolated(double red, double green, double blue) {
        int r = Math.min((int) red, LAST - 1);
        int g = Math.min((int) green, LAST - 1);
        int b = Math.min((int) blue, LAST - 1);
        double x = red - r;
        double y = green - g;
        double z = blue - b;
        int first = x >= y ? x >= z ? ALONG_RED : ALONG_BLUE : y >= z ? ALONG_GREEN : ALONG_BLUE;
        int last = x < y ? x < z ? ALONG_RED : ALONG_BLUE : y < z ? ALONG_GREEN : ALONG_BLUE;
        double max = Math.max(x, Math.max(y, z));
        double min = Math.min(x, Math.min(y, z));
        double middle = x + y + z - max - min;
        int corner = r * ALONG_RED + g * ALONG_GREEN + b * ALONG_BLUE;
        int opposite = corner + ALONG_RED + ALONG_GREEN + ALONG_BLUE;
        long p = point(corner);
        long p1 = point(corner + first);
        long p2 = point(opposite - last);
        long p3 = point(opposite);
        double share1 = max - middle;
        double share2 = middle - min;
        double share = 1 - max;
        return weighted(p, share, p1, share1, p2, share2, p3, min)
                | weighted(p >>> BITS, share, p1 >>> BITS, share1, p2 >>> BITS, share2, p3 >>> BITS, min) << BITS
                | weighted(p >>> 2 * BITS, share, p1 >>> 2 * BITS, share1, p2 >>> 2 * BITS, share2, p3 >>> 2 * BITS, min) << 2 * BITS;
    }

    /** Returns the weighted mean of the lowest codes of four points. */
    private static long weighted(long a, double shareA, long b, double shareB, long c, double shareC, long d, double shareD) {
        return (long) ((a & MASK) * shareA + (b & MASK) * shareB + (c & MASK) * shareC + (d & MASK) * shareD + 0.5);
    }

    private static long point(int at) {
        long point = (long) POINT.getOpaque(LATTICE, at);
        if (point == 0) {
            point = compute(at);
            POINT.setOpaque(LATTICE, at, point);
        }
        return point;
    }

    private static long compute(int at) {
        return codes(linear(at % POINTS), linear(at / POINTS % POINTS), linear(at / (POINTS * POINTS)));
    }

    private static long codes(double red, double green, double blue) {
        double[] color = Aces2.encoded(red, green, blue);
        return code(color[0]) | code(color[1]) << BITS | code(color[2]) << 2 * BITS;
    }

    private static long code(double v) {
        return Math.clamp(Math.round(ZERO + v * ONE), 1, MASK);
    }

    private static double step(double v) {
        return StrictMath.pow(v / (v + HALF), POWER);
    }

    /** Returns the linear value of a channel at a position. */
    private static double linear(int position) {
        double t = StrictMath.pow(MAX_STEP * position / LAST, 1 / POWER);
        return HALF * t / (1 - t);
    }
}
