package lightning.base.math;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Cubic lattice of colors, interpolated tetrahedrally: each cell is cut into six tetrahedra around its gray diagonal (Kasson, Nin,
 * Plouffe and Hafner, Performing color space conversions with three-dimensional linear interpolation, Journal of Electronic Imaging
 * 4(3), 1995), so that grays depend only on grays.
 *
 * <p>A point is computed when a color next to it is needed for the first time, because a picture needs few of them. Colors are codes of
 * 21 bits per channel from −0.5 to 1.5, red in the lowest ones.
 */
public final class ColorLattice {
    private static final int BITS = 21;
    private static final long MASK = (1L << BITS) - 1;
    /** Code of 0, and difference to that of 1. Codes are above 0, so that 0 is a point not computed yet. */
    private static final long ZERO = 1L << BITS - 2;
    private static final long ONE = 1L << BITS - 1;
    /** Threads may compute a point twice; each write is atomic and writes the same bits. */
    private static final VarHandle POINT = MethodHandles.arrayElementVarHandle(long[].class);

    private final int points;
    private final int last;
    private final int alongGreen;
    private final int alongBlue;
    private final Function function;
    private final long[] lattice;

    /** Colors at the points of a lattice. */
    @FunctionalInterface
    public interface Function {
        /**
         * Returns the color at a point.
         *
         * @param red position, 0 to 1, as {@code green} and {@code blue}
         * @return {@code double[3]}; values outside of −0.5…1.5 are clamped to it
         */
        double[] at(double red, double green, double blue);
    }

    /** @param points number of points along an edge */
    public ColorLattice(int points, Function function) {
        this.points = points;
        this.function = function;
        last = points - 1;
        alongGreen = points;
        alongBlue = points * points;
        lattice = new long[points * points * points];
    }

    /** Returns the codes of the color at a position, each coordinate 0 to 1. */
    public long color(double red, double green, double blue) {
        double atRed = last * red;
        double atGreen = last * green;
        double atBlue = last * blue;
        int r = Math.min((int) atRed, last - 1);
        int g = Math.min((int) atGreen, last - 1);
        int b = Math.min((int) atBlue, last - 1);
        double x = atRed - r;
        double y = atGreen - g;
        double z = atBlue - b;
        // From a corner of the cell along the axes, the largest fraction first, to the opposite corner.
        int first = x >= y ? x >= z ? 1 : alongBlue : y >= z ? alongGreen : alongBlue;
        int lastAxis = x < y ? x < z ? 1 : alongBlue : y < z ? alongGreen : alongBlue;
        double max = Math.max(x, Math.max(y, z));
        double min = Math.min(x, Math.min(y, z));
        double middle = x + y + z - max - min;
        int corner = r + g * alongGreen + b * alongBlue;
        int opposite = corner + 1 + alongGreen + alongBlue;
        long p = point(corner);
        long p1 = point(corner + first);
        long p2 = point(opposite - lastAxis);
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

    private long point(int at) {
        long point = (long) POINT.getOpaque(lattice, at);
        if (point == 0) {
            point = codes(function.at((double) (at % points) / last, (double) (at / points % points) / last,
                    (double) (at / alongBlue) / last));
            POINT.setOpaque(lattice, at, point);
        }
        return point;
    }

    /** Returns the codes of a color, {@code double[3]}. */
    public static long codes(double[] color) {
        return code(color[0]) | code(color[1]) << BITS | code(color[2]) << 2 * BITS;
    }

    private static long code(double v) {
        return Math.clamp(Math.round(ZERO + v * ONE), 1, MASK);
    }

    /** Returns the colors of codes, {@code double[3]}, clamped to 0…1. */
    public static double[] values(long codes) {
        return new double[] {value(codes), value(codes >>> BITS), value(codes >>> 2 * BITS)};
    }

    /** Returns the colors of codes, clamped to 0…1 and changed by a curve, {@code double[3]}. */
    public static double[] values(long codes, CurveTable curve) {
        double[] values = values(codes);
        for (int c = 0; c < 3; c++) {
            values[c] = curve.value((float) values[c]);
        }
        return values;
    }

    private static double value(long codes) {
        return Math.clamp((codes & MASK) - ZERO, 0, ONE) / (double) ONE;
    }

    /** Returns a color in 8 bits per channel, 0xRRGGBB, clamped. */
    public static int packed(long codes) {
        return code8(codes) << 16 | code8(codes >>> BITS) << 8 | code8(codes >>> 2 * BITS);
    }

    private static int code8(long codes) {
        return (int) (Math.clamp((codes & MASK) - ZERO, 0, ONE) * 255 + ONE / 2 >> BITS - 1);
    }

    /** Returns a color in 8 bits per channel, 0xRRGGBB, clamped and then changed by a curve. */
    public static int packed(long codes, CurveTable curve) {
        return code8(codes, curve) << 16 | code8(codes >>> BITS, curve) << 8 | code8(codes >>> 2 * BITS, curve);
    }

    private static int code8(long codes, CurveTable curve) {
        return (int) (255 * curve.value((float) value(codes)) + 0.5);
    }
}
