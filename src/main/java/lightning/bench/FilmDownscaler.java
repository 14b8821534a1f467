package lightning.bench;

import java.util.function.DoubleBinaryOperator;
import lightning.render.image.Film;

/** Downscaler of images by an integer factor, one pixel per square. */
final class FilmDownscaler {
    private FilmDownscaler() {}

    /**
     * Returns the image with the linear mean of each square.
     *
     * @param maxWidth maximum width of the result, pixels; narrower images are unchanged
     */
    static Film average(Film film, int maxWidth) {
        int factor = factor(film, maxWidth);
        return factor == 1 ? film : downscale(film, factor, Double::sum, factor * factor);
    }

    /** Returns the image with the maximum of each square, so that single pixels stay visible. */
    static Film maximum(Film film, int maxWidth) {
        int factor = factor(film, maxWidth);
        return factor == 1 ? film : downscale(film, factor, Math::max, 1);
    }

    private static int factor(Film film, int maxWidth) {
        return Math.min((film.width() - 1) / maxWidth + 1, film.height());
    }

    private static Film downscale(Film film, int factor, DoubleBinaryOperator combine, double divisor) {
        int width = film.width() / factor;
        int height = film.height() / factor;
        float[] from = film.toScanlines();
        float[] to = new float[3 * width * height];
        for (int i = 0; i < to.length; i++) {
            int left = i / 3 % width * factor;
            int top = i / 3 / width * factor;
            double value = 0;
            for (int y = top; y < top + factor; y++) {
                for (int x = left; x < left + factor; x++) {
                    value = combine.applyAsDouble(value, from[3 * (y * film.width() + x) + i % 3]);
                }
            }
            to[i] = (float) (value / divisor);
        }
        return Film.ofScanlines(width, height, to);
    }
}
