package lightning.render.gather.cell;

/**
 * Cosine-distributed directions around a normal, one in each cell of a square grid. Each cell of the grid is divided into 4×4 parts, and
 * a point has all its directions in the same part. Neighboring points have different parts ({@link CellKeys}), so together they have the
 * directions of a grid of four times the side. Within its part a direction is at a random place: there are sixteen patterns for each part.
 *
 * <p>The grid is mapped to the disc by concentric rings (P. Shirley and K. Chiu, A low distortion map between disk and square, 1997), and
 * the disc is projected onto the hemisphere (Malley's method).
 */
public final class DirectionTable {
    /** Parts of a cell along each axis. */
    private static final int PARTS = 4;
    /** Patterns of each part. */
    private static final int VARIANTS = 16;
    private static final int PATTERNS = PARTS * PARTS * VARIANTS;
    /** Smallest cosine to the normal. */
    private static final double MIN_COSINE = 1e-3;

    private final int rays;
    /** Coordinates of pattern p, ray k at {@code p * rays + k}; z is along the normal. */
    private final double[] x;
    private final double[] y;
    private final double[] z;

    /** @param side directions along each side of the grid */
    public DirectionTable(int side) {
        rays = side * side;
        x = new double[PATTERNS * rays];
        y = new double[PATTERNS * rays];
        z = new double[PATTERNS * rays];
        for (int i = 0; i < PATTERNS * rays; i++) {
            long h = Hash64.mix(i + 1);
            int k = i % rays;
            int part = i / rays / VARIANTS;
            map(i, coordinate(k % side, part % PARTS, h & 0xffffff, side), coordinate(k / side, part / PARTS, h >>> 24 & 0xffffff, side));
        }
    }

    /** Returns a coordinate in the square −1…1: in a part of a cell at a random place, in units of 2⁻²⁴ of a part. */
    private static double coordinate(int cell, int part, long random, int side) {
        return 2 * (cell + (part + random * 0x1p-24) / PARTS) / side - 1;
    }

    /** Maps a point of the square −1…1 to a direction. */
    private void map(int i, double a, double b) {
        double radius = Math.abs(a) > Math.abs(b) ? a : b;
        double angle = radius == 0 ? 0 : Math.abs(a) > Math.abs(b) ? Math.PI / 4 * b / a : Math.PI / 2 - Math.PI / 4 * a / b;
        x[i] = radius * StrictMath.cos(angle);
        y[i] = radius * StrictMath.sin(angle);
        z[i] = Math.sqrt(Math.max(MIN_COSINE * MIN_COSINE, 1 - x[i] * x[i] - y[i] * y[i]));
    }

    /** Returns the number of directions. */
    public int rays() {
        return rays;
    }

    /** Writes the usual directions around a normal, as below. */
    public void write(long seed, float nx, float ny, float nz, double[] toX, double[] toY, double[] toZ, int at) {
        write(seed, 0, nx, ny, nz, toX, toY, toZ, at);
    }

    /**
     * Writes the directions around a normal to elements {@code at … at + rays() − 1}. The tangents follow T. Duff and others, Building an
     * orthonormal basis, revisited, 2017.
     *
     * @param seed its lowest four bits are the part, the others select one of its patterns
     * @param turn bits of the part to change: 0 for the usual directions, up to 15 for those in the other parts
     * @param toX  receives the components x, as {@code toY} and {@code toZ}
     */
    public void write(long seed, int turn, float nx, float ny, float nz, double[] toX, double[] toY, double[] toZ, int at) {
        int part = (int) (seed & PARTS * PARTS - 1) ^ turn;
        int from = (int) (part * VARIANTS + (Hash64.mix(seed) & VARIANTS - 1)) * rays;
        double sign = Math.copySign(1.0, nz);
        double a = -1 / (sign + nz);
        double b = (double) nx * ny * a;
        double tx = 1 + sign * nx * nx * a;
        double ty = sign * b;
        double tz = -sign * nx;
        double by = sign + (double) ny * ny * a;
        double bz = -ny;
        for (int k = 0; k < rays; k++) {
            double u = x[from + k];
            double v = y[from + k];
            double w = z[from + k];
            toX[at + k] = u * tx + v * b + w * nx;
            toY[at + k] = u * ty + v * by + w * ny;
            toZ[at + k] = u * tz + v * bz + w * nz;
        }
    }
}
