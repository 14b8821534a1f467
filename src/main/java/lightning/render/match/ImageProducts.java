package lightning.render.match;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Weighted sums of the products of images, two at a time, for each channel: all that least squares need of them.
 *
 * @param sums {@code double[channel][image][image]}, symmetric
 */
record ImageProducts(double[][][] sums) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * @param images  {@code float[channel][cell]} of each
     * @param weights of each cell, ≥ 0
     */
    static ImageProducts of(List<float[][]> images, double[] weights) {
        int count = images.size();
        double[][][] sums = new double[3][count][count];
        IntStream.range(0, 3 * count).parallel().forEach(task -> {
            int c = task % 3;
            int i = task / 3;
            float[] first = images.get(i)[c];
            for (int j = 0; j <= i; j++) {
                float[] second = images.get(j)[c];
                double sum = 0;
                for (int p = 0; p < weights.length; p++) {
                    sum += weights[p] * first[p] * second[p];
                }
                sums[c][i][j] = sum;
                sums[c][j][i] = sum;
            }
        });
        return new ImageProducts(sums);
    }

    /** Returns the sums of the weighted sums of both. */
    ImageProducts plus(ImageProducts other) {
        double[][][] total = new double[3][][];
        for (int c = 0; c < 3; c++) {
            total[c] = new double[sums[c].length][];
            for (int i = 0; i < total[c].length; i++) {
                total[c][i] = sums[c][i].clone();
                for (int j = 0; j < total[c].length; j++) {
                    total[c][i][j] += other.sums[c][i][j];
                }
            }
        }
        return new ImageProducts(total);
    }

    double of(int channel, int i, int j) {
        return sums[channel][i][j];
    }

    /** Returns the cosine of the angle between two images; 0 if one of them is black where cells count. */
    double cosine(int i, int j) {
        double[] totals = new double[3];
        for (double[][] channel : sums) {
            totals[0] += channel[i][j];
            totals[1] += channel[i][i];
            totals[2] += channel[j][j];
        }
        return totals[1] == 0 || totals[2] == 0 ? 0 : totals[0] / Math.sqrt(totals[1] * totals[2]);
    }

    /**
     * Returns the weighted sum of squares of a sum of images.
     *
     * @param factors of each image: {@code double[channel][image]}
     */
    double squares(double[][] factors) {
        double total = 0;
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < factors[c].length; i++) {
                for (int j = 0; j < factors[c].length; j++) {
                    total += factors[c][i] * factors[c][j] * sums[c][i][j];
                }
            }
        }
        return Math.max(0, total);
    }
}
