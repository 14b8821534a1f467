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
    private static final int STEP_BITS = 32 - BITS;
    private static final int STEPS = 1 << STEP_BITS;
    /** Half a step for each of two channels. */
    private static final long HALVES = STEPS / 2 | (long) STEPS / 2 << 32;
    /** Threads may compute a point twice; each write is atomic and writes the same bits. */
    private static final VarHandle POINT = MethodHandles.arrayElementVarHandle(long[].class);

    private final int points;
    private final int last;
    private final int alongGreen;
    private final int alongBlue;
    private final int[] along;
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
        along = new int[] {1, alongGreen, alongBlue};
        lattice = new long[points * points * points];
    }

    /** Returns the codes of the color at a position, each coordinate 0 to 1, rounded to {@link #STEPS} steps of a cell. */
    public long color(double red, double green, double blue) {
        int atRed = (int) (last * STEPS * red + 0.5);
        int atGreen = (int) (last * STEPS * green + 0.5);
        int atBlue = (int) (last * STEPS * blue + 0.5);
        int r = Math.min(atRed >> STEP_BITS, last - 1);
        int g = Math.min(atGreen >> STEP_BITS, last - 1);
        int b = Math.min(atBlue >> STEP_BITS, last - 1);
        // The fraction of each axis, with its number in the lowest bits, sorted without branches.
        int x = atRed - (r << STEP_BITS) << 2;
        int y = atGreen - (g << STEP_BITS) << 2 | 1;
        int z = atBlue - (b << STEP_BITS) << 2 | 2;
        int most = Math.max(x, Math.max(y, z));
        int least = Math.min(x, Math.min(y, z));
        int max = most >> 2;
        int min = least >> 2;
        int middle = x + y + z - most - least >> 2;
        int corner = r + g * alongGreen + b * alongBlue;
        int opposite = corner + 1 + alongGreen + alongBlue;
        long p = point(corner);
        // From a corner of the cell along the axes, the largest fraction first, to the opposite corner.
        long p1 = point(corner + along[most & 3]);
        long p2 = point(opposite - along[least & 3]);
        long p3 = point(opposite);
        // Two channels at once: a sum of codes, times shares that add up to STEPS, has 32 bits.
        long redBlue = spread(p) * (STEPS - max) + spread(p1) * (max - middle) + spread(p2) * (middle - min) + spread(p3) * min + HALVES;
        long greens = green(p) * (STEPS - max) + green(p1) * (max - middle) + green(p2) * (middle - min) + green(p3) * min + STEPS / 2;
        return redBlue >>> STEP_BITS & MASK | greens >>> STEP_BITS << BITS | redBlue >>> 32 + STEP_BITS << 2 * BITS;
    }

    /** Returns the code of red in the lowest 32 bits, and that of blue in the highest. */
    private static long spread(long codes) {
        return codes & MASK | codes >>> 2 * BITS << 32;
    }

    private static long green(long codes) {
        return codes >>> BITS & MASK;
    }

    private long point(int at) {
        long point = (long) POINT.getOpaque(lattice, at);
        return point == 0 ? compute(at) : point;
    }

    private long compute(int at) {
        long point = codes(function.at((double) (at % points) / last, (double) (at / points % points) / last,
                (double) (at / alongBlue) / last));
        POINT.setOpaque(lattice, at, point);
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
