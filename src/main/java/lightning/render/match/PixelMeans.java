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
        return of(film, null).values;
    }

    /**
     * Returns the means of the pixels that count.
     *
     * @param weights by pixel; null if all are 1
     */
    Means of(Film film, float @Nullable [] weights) {
        float[][] values = new float[3][columns * rows];
        float[] sums = new float[columns * rows];
        for (int row = 0; row < rows; row++) {
            double top = (double) row * film.height() / rows;
            double bottom = (double) (row + 1) * film.height() / rows;
            for (int column = 0; column < columns; column++) {
                double left = (double) column * film.width() / columns;
                double right = (double) (column + 1) * film.width() / columns;
                addCell(film, weights, left, top, right, bottom, row * columns + column, values, sums);
            }
        }
        return new Means(values, sums);
    }

    private static void addCell(Film film, float @Nullable [] weights, double left, double top, double right,
            double bottom, int cell, float[][] values, float[] sums) {
        double red = 0;
        double green = 0;
        double blue = 0;
        double total = 0;
        for (int y = (int) top; y < Math.min(film.height(), Math.ceil(bottom)); y++) {
            double high = Math.min(y + 1, bottom) - Math.max(y, top);
            for (int x = (int) left; x < Math.min(film.width(), Math.ceil(right)); x++) {
                double part = high * (Math.min(x + 1, right) - Math.max(x, left));
                double weight = weights == null ? part : part * weights[y * film.width() + x];
                red += weight * film.red(x, y);
                green += weight * film.green(x, y);
                blue += weight * film.blue(x, y);
                total += weight;
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
