package lightning.render.gather;

/**
 * Cosine-distributed directions around a normal, one in each cell of a square grid, at a random place of the cell. 64 patterns in 256
 * rotations are tabulated, so no trigonometric function is evaluated per ray.
 *
 * <p>The grid is mapped to the disc by concentric rings (P. Shirley and K. Chiu, A low distortion map between disk and square, 1997), and
 * the disc is projected onto the hemisphere (Malley's method).
 */
public final class DirectionTable {
    private static final int PATTERNS = 64;
    private static final int ROTATIONS = 256;
    /** Smallest cosine to the normal. */
    private static final double MIN_COSINE = 1e-3;

    private final int rays;
    /** Coordinates of pattern p, ray k at {@code p * rays + k}; z is along the normal. */
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] cosine = new double[ROTATIONS];
    private final double[] sine = new double[ROTATIONS];

    /** @param side directions along each side of the grid */
    public DirectionTable(int side) {
        rays = side * side;
        x = new double[PATTERNS * rays];
        y = new double[PATTERNS * rays];
        z = new double[PATTERNS * rays];
        for (int i = 0; i < PATTERNS * rays; i++) {
            long h = Hash64.mix(i + 1);
            int k = i % rays;
            map(i, 2 * (k % side + (h & 0xffffff) * 0x1p-24) / side - 1, 2 * (k / side + (h >>> 24 & 0xffffff) * 0x1p-24) / side - 1);
        }
        for (int r = 0; r < ROTATIONS; r++) {
            cosine[r] = StrictMath.cos(2 * Math.PI * r / ROTATIONS);
            sine[r] = StrictMath.sin(2 * Math.PI * r / ROTATIONS);
        }
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

    /**
     * Writes the directions around a normal to elements {@code at … at + rays() − 1}. The tangents follow T. Duff and others, Building an
     * orthonormal basis, revisited, 2017.
     *
     * @param seed selects the pattern and the rotation
     * @param toX  receives the components x, as {@code toY} and {@code toZ}
     */
    public void write(long seed, float nx, float ny, float nz, double[] toX, double[] toY, double[] toZ, int at) {
        long h = Hash64.mix(seed);
        int from = (int) (h & PATTERNS - 1) * rays;
        int rotation = (int) (h >>> 32 & ROTATIONS - 1);
        double sign = Math.copySign(1.0, nz);
        double a = -1 / (sign + nz);
        double b = (double) nx * ny * a;
        double tx = 1 + sign * nx * nx * a;
        double ty = sign * b;
        double tz = -sign * nx;
        double by = sign + (double) ny * ny * a;
        double bz = -ny;
        for (int k = 0; k < rays; k++) {
            double u = x[from + k] * cosine[rotation] - y[from + k] * sine[rotation];
            double v = x[from + k] * sine[rotation] + y[from + k] * cosine[rotation];
            double w = z[from + k];
            toX[at + k] = u * tx + v * b + w * nx;
            toY[at + k] = u * ty + v * by + w * ny;
            toZ[at + k] = u * tz + v * bz + w * nz;
        }
    }
}
