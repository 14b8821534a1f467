package lightning.render.image;

import java.util.Arrays;

/**
 * Band of rows of a displayed picture in the perceptual space of {@link Flip}: perceived colors, edges and points. The picture is
 * clamped at its border.
 *
 * <p>Uses doubles: the root in a detector's response turns float rounding errors in a flat picture into errors of 1e-4.
 */
final class FlipBand {
    private final EyeFilters filters;
    private final int width;
    private final int rows;

    /** Hunt-adjusted L*, a*, b* after the blur of the eye: {@code double[3][rows * width]}. */
    final double[][] lab;
    /** The strength of an edge, 0…√2: {@code double[rows * width]}. */
    final double[] edges;
    /** The strength of a point, 0…√2: {@code double[rows * width]}. */
    final double[] points;

    /** Prepares the rows {@code top} to {@code top + rows − 1} of a picture of display codes. */
    FlipBand(int[] pixels, int width, int height, int top, int rows, EyeFilters filters) {
        this.filters = filters;
        this.width = width;
        this.rows = rows;
        double[][] opponent = opponent(pixels, height, top);
        double[] light = new double[opponent[0].length];
        for (int i = 0; i < light.length; i++) {
            light[i] = (opponent[0][i] + 16) / 116;
        }
        double[] smooth = filterHorizontally(light, filters.gauss);
        edges = strength(filterHorizontally(light, filters.edge), smooth, filters.edge);
        points = strength(filterHorizontally(light, filters.point), smooth, filters.point);
        lab = perceivedLab(opponent);
    }

    /** Returns Y, Cx, Cz of the rows and of a margin above and below. */
    private double[][] opponent(int[] pixels, int height, int top) {
        int margin = filters.radius;
        double[][] planes = new double[3][(rows + 2 * margin) * width];
        for (int row = 0, at = 0; row < rows + 2 * margin; row++) {
            int from = Math.clamp(top + row - margin, 0, height - 1) * width;
            for (int x = 0; x < width; x++, at++) {
                int rgb = pixels[from + x];
                OpponentColor.toYCxCz(Srgb.linear(rgb >> 16 & 0xFF), Srgb.linear(rgb >> 8 & 0xFF), Srgb.linear(rgb & 0xFF),
                        planes, at);
            }
        }
        return planes;
    }

    private double[][] perceivedLab(double[][] opponent) {
        double[] blue = blur(opponent[2], filters.blueYellow[0]);
        double[] yellow = blur(opponent[2], filters.blueYellow[1]);
        for (int i = 0; i < blue.length; i++) {
            blue[i] += yellow[i];
        }
        double[][] planes = {blur(opponent[0], filters.light), blur(opponent[1], filters.redGreen), blue};
        for (int i = 0; i < blue.length; i++) {
            OpponentColor.toHuntLab(planes, i);
        }
        return planes;
    }

    private double[] blur(double[] plane, double[] weights) {
        return filterVertically(filterHorizontally(plane, weights), weights);
    }

    /** Returns the length of the vector of a detector's responses across and down. */
    private double[] strength(double[] detectedAcross, double[] smoothAcross, double[] detector) {
        double[] x = filterVertically(detectedAcross, filters.gauss);
        double[] y = filterVertically(smoothAcross, detector);
        for (int i = 0; i < x.length; i++) {
            x[i] = Math.sqrt(x[i] * x[i] + y[i] * y[i]);
        }
        return x;
    }

    /** Filters a plane with margins across. */
    private double[] filterHorizontally(double[] plane, double[] weights) {
        int radius = weights.length / 2;
        double[] to = new double[plane.length];
        double[] row = new double[width + 2 * radius];
        double[] sums = new double[width];
        for (int start = 0; start < plane.length; start += width) {
            Arrays.fill(row, 0, radius, plane[start]);
            System.arraycopy(plane, start, row, radius, width);
            Arrays.fill(row, radius + width, row.length, plane[start + width - 1]);
            Arrays.fill(sums, 0);
            for (int k = 0; k < weights.length; k++) {
                add(weights[k], row, k, sums);
            }
            System.arraycopy(sums, 0, to, start, width);
        }
        return to;
    }

    /** Filters a plane with margins down; returns only the rows. */
    private double[] filterVertically(double[] plane, double[] weights) {
        int radius = weights.length / 2;
        double[] to = new double[rows * width];
        double[] sums = new double[width];
        for (int y = 0; y < rows; y++) {
            Arrays.fill(sums, 0);
            for (int k = 0; k < weights.length; k++) {
                add(weights[k], plane, (filters.radius + y + k - radius) * width, sums);
            }
            System.arraycopy(sums, 0, to, y * width, width);
        }
        return to;
    }

    private static void add(double weight, double[] from, int at, double[] sums) {
        for (int x = 0; x < sums.length; x++) {
            sums[x] += weight * from[at + x];
        }
    }
}
