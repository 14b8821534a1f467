package lightning.render.image;

/**
 * Color spaces of {@link Flip}: from linear sRGB through CIE XYZ (D65) to the linear opponent space YCxCz, in which the eye's blur
 * is applied, and to CIE L*a*b*, whose chroma is scaled by lightness (Hunt effect: dark colors look less colorful).
 *
 * <p>The matrix is that of the sRGB primaries in exact fractions, as in the published definition of FLIP. Its inverse and the white
 * point are computed from it, so that gray has exactly no chroma.
 */
final class OpponentColor {
    private static final double[][] TO_XYZ = {
        {10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0},
        {2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0},
        {1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0}
    };
    /** Row sums of the matrix: XYZ of linear RGB (1, 1, 1). */
    private static final double[] WHITE = {sum(TO_XYZ[0]), sum(TO_XYZ[1]), sum(TO_XYZ[2])};
    /** Matrix from linear RGB to XYZ relative to white. */
    private static final double[][] TO_RELATIVE = relativeMatrix();
    private static final double[][] FROM_RELATIVE = inverse(TO_RELATIVE);
    /** CIE: below (6/29)³ the cube root continues as a line. */
    private static final double LINEAR_BELOW = 216.0 / 24389;

    private OpponentColor() {}

    /** Writes Y, Cx, Cz of linear RGB 0…1 to {@code to[plane][at]}. */
    static void toYCxCz(double r, double g, double b, double[][] to, int at) {
        double x = row(TO_RELATIVE[0], r, g, b);
        double y = row(TO_RELATIVE[1], r, g, b);
        double z = row(TO_RELATIVE[2], r, g, b);
        to[0][at] = 116 * y - 16;
        to[1][at] = 500 * (x - y);
        to[2][at] = 200 * (y - z);
    }

    /** Replaces Y, Cx, Cz at {@code planes[0…2][at]} by Hunt-adjusted L*, a*, b* of that color clamped to linear RGB 0…1. */
    static void toHuntLab(double[][] planes, int at) {
        double y = (planes[0][at] + 16) / 116;
        double x = y + planes[1][at] / 500;
        double z = y - planes[2][at] / 200;
        double r = clamp(row(FROM_RELATIVE[0], x, y, z));
        double g = clamp(row(FROM_RELATIVE[1], x, y, z));
        double b = clamp(row(FROM_RELATIVE[2], x, y, z));
        writeHuntLab(r, g, b, planes, at);
    }

    /** Writes Hunt-adjusted L*, a*, b* of linear RGB 0…1 to {@code to[plane][at]}. */
    static void writeHuntLab(double r, double g, double b, double[][] to, int at) {
        double fx = lightness(row(TO_RELATIVE[0], r, g, b));
        double fy = lightness(row(TO_RELATIVE[1], r, g, b));
        double fz = lightness(row(TO_RELATIVE[2], r, g, b));
        double l = 116 * fy - 16;
        to[0][at] = l;
        to[1][at] = 0.01 * l * 500 * (fx - fy);
        to[2][at] = 0.01 * l * 200 * (fy - fz);
    }

    private static double lightness(double t) {
        return t > LINEAR_BELOW ? Math.cbrt(t) : t * (841.0 / 108) + 4.0 / 29;
    }

    private static double clamp(double v) {
        return Math.clamp(v, 0.0, 1.0);
    }

    private static double row(double[] m, double x, double y, double z) {
        return m[0] * x + m[1] * y + m[2] * z;
    }

    private static double sum(double[] values) {
        return values[0] + values[1] + values[2];
    }

    private static double[][] relativeMatrix() {
        double[][] m = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                m[i][j] = TO_XYZ[i][j] / WHITE[i];
            }
        }
        return m;
    }

    /** Inverts by cofactors. */
    private static double[][] inverse(double[][] m) {
        double[][] inverse = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                int r = (i + 1) % 3;
                int s = (i + 2) % 3;
                int c = (j + 1) % 3;
                int d = (j + 2) % 3;
                inverse[j][i] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
            }
        }
        double determinant = row(m[0], inverse[0][0], inverse[1][0], inverse[2][0]);
        for (double[] row : inverse) {
            for (int j = 0; j < 3; j++) {
                row[j] /= determinant;
            }
        }
        return inverse;
    }
}
