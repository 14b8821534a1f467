package lightning.scene.asset;

import lightning.base.math.Rgb;

/**
 * Integrals of an image, which give its mean color over any rectangle in constant time (Crow, Summed-area tables for texture mapping,
 * SIGGRAPH 1984). Immutable.
 *
 * <p>The image covers the unit square: x to the right, y down. A rectangle may reach up to one image beyond its edges, where the image is
 * mirrored. Rectangles of one size that cover all places evenly therefore have the mean of the image.
 *
 * <p>An image with more than {@link #MAX_CELLS} pixels along a side is reduced to as many cells, each with the mean of its area.
 */
public final class SummedAreaTable {
    private static final int MAX_CELLS = 256;

    private final int columns;
    private final int rows;
    /** Integral from the upper left corner to each corner of a cell, for red, green and blue: {@code rows + 1} rows of corners. */
    private final double[][] integrals;
    private final float max;

    /** Creates the table of an image whose values are at least 0. */
    SummedAreaTable(Texture image) {
        columns = Math.min(image.width(), MAX_CELLS);
        rows = Math.min(image.height(), MAX_CELLS);
        integrals = new double[3][(columns + 1) * (rows + 1)];
        float largest = 0;
        for (int c = 0; c < 3; c++) {
            largest = Math.max(largest, integrate(image, c));
        }
        max = largest;
    }

    /** Fills in one channel; returns its largest value. */
    private float integrate(Texture image, int c) {
        float largest = 0;
        double[] above = new double[columns + 1];
        double[] line = new double[columns + 1];
        int row = 1;
        for (int y = 0; y < image.height(); y++) {
            double sum = 0;
            int column = 1;
            for (int x = 0; x < image.width(); x++) {
                double value = image.channel(x, y, c);
                largest = Math.max(largest, (float) value);
                for (; column <= columns && corner(column, columns, image.width()) <= x + 1; column++) {
                    line[column] = sum + value * (corner(column, columns, image.width()) - x);
                }
                sum += value;
            }
            for (; row <= rows && corner(row, rows, image.height()) <= y + 1; row++) {
                double part = corner(row, rows, image.height()) - y;
                for (int i = 0; i <= columns; i++) {
                    integrals[c][row * (columns + 1) + i] = (above[i] + line[i] * part) / ((double) image.width() * image.height());
                }
            }
            for (int i = 0; i <= columns; i++) {
                above[i] += line[i];
            }
        }
        return largest;
    }

    /** Returns the position of a corner in pixels; the last one is exactly at the edge. */
    private static double corner(int i, int cells, int pixels) {
        return (double) i * pixels / cells;
    }

    /** Returns the largest value of any pixel and channel. */
    public float max() {
        return max;
    }

    /** Returns the mean color of the image. */
    public Rgb mean() {
        return new Rgb(mean(0, 0, 1, 1, 0), mean(0, 0, 1, 1, 1), mean(0, 0, 1, 1, 2));
    }

    /**
     * Returns the mean of one channel (0 red, 1 green, 2 blue) over a rectangle, 0 … {@link #max}.
     *
     * @param x0 left edge, −1 … 1
     * @param y0 upper edge, −1 … 1
     * @param x1 right edge, above {@code x0}, at most 2
     * @param y1 lower edge, above {@code y0}, at most 2
     */
    public float mean(double x0, double y0, double x1, double y1, int channel) {
        double[] to = integrals[channel];
        double sum = mirrored(to, x1, y1) - mirrored(to, x0, y1) - mirrored(to, x1, y0) + mirrored(to, x0, y0);
        return (float) Math.clamp(sum / ((x1 - x0) * (y1 - y0)), 0, max);
    }

    /** Returns the integral from the upper left corner to a point, which may be beyond the edges; negative in one direction. */
    private double mirrored(double[] to, double x, double y) {
        if (x < 0) {
            return -mirrored(to, -x, y);
        }
        if (x > 1) {
            return 2 * mirrored(to, 1, y) - mirrored(to, 2 - x, y);
        }
        if (y < 0) {
            return -mirrored(to, x, -y);
        }
        if (y > 1) {
            return 2 * mirrored(to, x, 1) - mirrored(to, x, 2 - y);
        }
        double column = x * columns;
        double row = y * rows;
        int left = Math.min((int) column, columns - 1);
        int top = Math.min((int) row, rows - 1);
        int at = top * (columns + 1) + left;
        double u = column - left;
        double v = row - top;
        double above = to[at] * (1 - u) + to[at + 1] * u;
        double below = to[at + columns + 1] * (1 - u) + to[at + columns + 2] * u;
        return above * (1 - v) + below * v;
    }
}
