package lightning.render.image;

import java.util.Arrays;

/**
 * Structural similarity (Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from error visibility to structural
 * similarity", 2004): the mean over all windows of {@code (2·μa·μb + C1)(2·σab + C2) / ((μa² + μb² + C1)(σa² + σb² + C2))}, with C1
 * = (0.01·255)² and C2 = (0.03·255)².
 *
 * <p>The window is the paper's: 11 × 11 pixels weighted by a Gaussian of 1.5 pixels, at every position inside the picture. If a
 * side of the picture is shorter, the window is cut to it.
 */
final class Ssim {

    static final int WINDOW = 11;
    static final double SIGMA = 1.5;
    static final double C1 = (0.01 * 255) * (0.01 * 255);
    static final double C2 = (0.03 * 255) * (0.03 * 255);

    /** a, b, a², b², ab. */
    private static final int MOMENTS = 5;

    private Ssim() {}

    /** Returns the similarity of the displayed luma 0…255 (weights of BT.709 on sRGB codes) of two films of one size. */
    static double displayedLuma(Film a, Film b) {
        int width = a.width();
        double[] across = gaussian(Math.min(WINDOW, width));
        double[] down = gaussian(Math.min(WINDOW, a.height()));
        int positions = width - across.length + 1;
        // Only the rows under the window are stored, blurred across, in a ring buffer by row number.
        double[][] rows = new double[down.length][MOMENTS * positions];
        double[] lumaA = new double[width];
        double[] lumaB = new double[width];
        double[] moments = new double[MOMENTS * positions];
        double sum = 0;
        for (int y = 0; y < a.height(); y++) {
            luma(a, y, lumaA);
            luma(b, y, lumaB);
            blurAcross(lumaA, lumaB, across, rows[y % down.length]);
            if (y >= down.length - 1) {
                blurDown(rows, y - down.length + 1, down, moments);
                sum += sumOfSimilarities(moments);
            }
        }
        return sum / ((double) positions * (a.height() - down.length + 1));
    }

    /** Returns Gaussian weights around the middle of {@code size} pixels, with sum 1. */
    private static double[] gaussian(int size) {
        double[] weights = new double[size];
        double sum = 0;
        for (int i = 0; i < size; i++) {
            double distance = i - (size - 1) / 2.0;
            weights[i] = Math.exp(-distance * distance / (2 * SIGMA * SIGMA));
            sum += weights[i];
        }
        for (int i = 0; i < size; i++) {
            weights[i] /= sum;
        }
        return weights;
    }

    private static void luma(Film film, int y, double[] row) {
        for (int x = 0; x < row.length; x++) {
            row[x] = 0.2126 * Srgb.encode(film.red(x, y)) + 0.7152 * Srgb.encode(film.green(x, y))
                    + 0.0722 * Srgb.encode(film.blue(x, y));
        }
    }

    private static void blurAcross(double[] a, double[] b, double[] weights, double[] moments) {
        for (int at = 0; at < moments.length / MOMENTS; at++) {
            double meanA = 0;
            double meanB = 0;
            double squareA = 0;
            double squareB = 0;
            double product = 0;
            for (int i = 0; i < weights.length; i++) {
                double weight = weights[i];
                double valueA = a[at + i];
                double valueB = b[at + i];
                meanA += weight * valueA;
                meanB += weight * valueB;
                squareA += weight * (valueA * valueA);
                squareB += weight * (valueB * valueB);
                product += weight * (valueA * valueB);
            }
            moments[MOMENTS * at] = meanA;
            moments[MOMENTS * at + 1] = meanB;
            moments[MOMENTS * at + 2] = squareA;
            moments[MOMENTS * at + 3] = squareB;
            moments[MOMENTS * at + 4] = product;
        }
    }

    private static void blurDown(double[][] rows, int top, double[] weights, double[] moments) {
        Arrays.fill(moments, 0);
        for (int i = 0; i < weights.length; i++) {
            double weight = weights[i];
            double[] row = rows[(top + i) % rows.length];
            for (int j = 0; j < moments.length; j++) {
                moments[j] += weight * row[j];
            }
        }
    }

    private static double sumOfSimilarities(double[] m) {
        double sum = 0;
        for (int i = 0; i < m.length; i += MOMENTS) {
            double meanA = m[i];
            double meanB = m[i + 1];
            double varianceA = m[i + 2] - meanA * meanA;
            double varianceB = m[i + 3] - meanB * meanB;
            double covariance = m[i + 4] - meanA * meanB;
            sum += (2 * meanA * meanB + C1) * (2 * covariance + C2)
                    / ((meanA * meanA + meanB * meanB + C1) * (varianceA + varianceB + C2));
        }
        return sum;
    }
}
