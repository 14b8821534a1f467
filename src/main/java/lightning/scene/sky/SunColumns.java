package lightning.scene.sky;

import java.util.Arrays;

/**
 * Columns of air from a point to its top, as a table by height and direction.
 *
 * <p>Heights and directions have the spacing of Bruneton (Precomputed atmospheric scattering, 2017 implementation): by the distance to the horizon, and
 * by the distance to the top between its least and its greatest.
 */
final class SunColumns {
    private static final int HEIGHTS = 48;
    private static final int DIRECTIONS = 128;
    private static final int STEPS = 96;
    private static final double HORIZON = Math.sqrt(Atmosphere.TOP * Atmosphere.TOP - Atmosphere.GROUND * Atmosphere.GROUND);
    /** Columns of every sky: only the coefficients differ. */
    static final SunColumns TABLE = new SunColumns();

    private final float[] columns = new float[HEIGHTS * DIRECTIONS * Atmosphere.COLUMNS];

    private SunColumns() {
        double[] sum = new double[Atmosphere.COLUMNS];
        double[] density = new double[Atmosphere.COLUMNS];
        for (int h = 0; h < HEIGHTS; h++) {
            double rho = HORIZON * h / (HEIGHTS - 1);
            double r = Math.sqrt(rho * rho + Atmosphere.GROUND * Atmosphere.GROUND);
            double least = Atmosphere.TOP - r;
            for (int d = 0; d < DIRECTIONS; d++) {
                double length = least + (rho + HORIZON - least) * d / (DIRECTIONS - 1);
                double cos = length == 0 ? 1 : Math.clamp((HORIZON * HORIZON - rho * rho - length * length) / (2 * r * length), -1, 1);
                Arrays.fill(sum, 0);
                for (int i = 0; i < STEPS; i++) {
                    double t = (i + 0.5) / STEPS;
                    double at = length * t * t;
                    double step = length * 2 * t / STEPS;
                    Atmosphere.writeDensities(Math.sqrt(at * at + 2 * r * cos * at + r * r), density);
                    Atmosphere.addColumns(sum, density, step);
                }
                for (int c = 0; c < Atmosphere.COLUMNS; c++) {
                    columns[index(h, d) + c] = (float) sum[c];
                }
            }
        }
    }

    private static int index(int height, int direction) {
        return (height * DIRECTIONS + direction) * Atmosphere.COLUMNS;
    }

    /**
     * Writes the columns toward a direction, in meters at the density of the ground.
     *
     * @param r   distance from the earth's center
     * @param cos cosine of the angle to the vertical
     * @param to  receives {@code double[COLUMNS]}
     * @return false if the ground is in the way; then nothing is written
     */
    boolean write(double r, double cos, double[] to) {
        if (r * r * (cos * cos - 1) + Atmosphere.GROUND * Atmosphere.GROUND > 0 && cos < 0) {
            return false;
        }
        double rho = Math.sqrt(Math.max(0, r * r - Atmosphere.GROUND * Atmosphere.GROUND));
        double least = Math.max(0, Atmosphere.TOP - r);
        double most = rho + HORIZON;
        double h = Math.clamp(rho / HORIZON, 0, 1) * (HEIGHTS - 1);
        double d = Math.clamp((Atmosphere.toTop(r, cos) - least) / (most - least), 0, 1) * (DIRECTIONS - 1);
        int h0 = Math.min((int) h, HEIGHTS - 2);
        int d0 = Math.min((int) d, DIRECTIONS - 2);
        double s = h - h0;
        double t = d - d0;
        for (int c = 0; c < Atmosphere.COLUMNS; c++) {
            double low = columns[index(h0, d0) + c] * (1 - t) + columns[index(h0, d0 + 1) + c] * t;
            double high = columns[index(h0 + 1, d0) + c] * (1 - t) + columns[index(h0 + 1, d0 + 1) + c] * t;
            to[c] = low * (1 - s) + high * s;
        }
        return true;
    }
}
