package lightning.render.match;

import lightning.render.image.Film;
import org.jspecify.annotations.Nullable;

/**
 * Means of an image over the cells of a grid that covers it, for images of any size. A pixel counts in each cell by the part of the cell that
 * it covers.
 *
 * @param columns cells side by side
 * @param rows    cells one below the other
 */
record PixelMeans(int columns, int rows) {

    /** Weighted means of an image: {@code values[channel][cell]}, and the sum of the weights of each cell, 1 if all pixels have weight 1. */
    record Means(float[][] values, float[] weights) {
        // Arrays in a record: written once by their creator, never after.
    }

    /** Returns the means of a film all of whose pixels count. */
    float[][] of(Film film) {
        return of(planes(film), new PixelMeans(film.width(), film.height()));
    }

    /**
     * Returns the means of an image over larger cells.
     *
     * @param image {@code float[channel][cell]} of cells of {@code from}; not modified
     */
    float[][] of(float[][] image, PixelMeans from) {
        return from.equals(this) ? image : of(image, from, null).values;
    }

    private static float[][] planes(Film film) {
        float[] rgb = film.toScanlines();
        float[][] planes = new float[3][rgb.length / 3];
        for (int i = 0; i < rgb.length; i++) {
            planes[i % 3][i / 3] = rgb[i];
        }
        return planes;
    }

    /**
     * Returns the means of the pixels that count; the others may be infinite or not a number.
     *
     * @param weights by pixel
     */
    Means of(Film film, float[] weights) {
        return of(planes(film), new PixelMeans(film.width(), film.height()), weights);
    }

    private Means of(float[][] image, PixelMeans from, float @Nullable [] weights) {
        float[][] values = new float[3][columns * rows];
        float[] sums = new float[columns * rows];
        for (int row = 0; row < rows; row++) {
            double top = (double) row * from.rows / rows;
            double bottom = (double) (row + 1) * from.rows / rows;
            for (int column = 0; column < columns; column++) {
                double left = (double) column * from.columns / columns;
                double right = (double) (column + 1) * from.columns / columns;
                addCell(image, from, weights, left, top, right, bottom, row * columns + column, values, sums);
            }
        }
        return new Means(values, sums);
    }

    private static void addCell(float[][] image, PixelMeans from, float @Nullable [] weights, double left, double top, double right,
            double bottom, int cell, float[][] values, float[] sums) {
        double red = 0;
        double green = 0;
        double blue = 0;
        double total = 0;
        for (int y = (int) top; y < Math.min(from.rows, Math.ceil(bottom)); y++) {
            double high = Math.min(y + 1, bottom) - Math.max(y, top);
            for (int x = (int) left; x < Math.min(from.columns, Math.ceil(right)); x++) {
                double part = high * (Math.min(x + 1, right) - Math.max(x, left));
                int i = y * from.columns + x;
                double weight = weights == null ? part : part * weights[i];
                if (weight != 0) {
                    red += weight * image[0][i];
                    green += weight * image[1][i];
                    blue += weight * image[2][i];
                    total += weight;
                }
            }
        }
        if (total > 0) {
            values[0][cell] = (float) (red / total);
            values[1][cell] = (float) (green / total);
            values[2][cell] = (float) (blue / total);
            sums[cell] = (float) (total / ((right - left) * (bottom - top)));
        }
    }
}
