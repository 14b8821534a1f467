package lightning.review;

import lightning.render.image.Film;
import lightning.scene.PictureSettings;

/** Small version of a film for the filmstrip of a page. It is a mean, so thumbnails of layers add up to that of their sum. */
final class Thumbnail {
    private static final int MAX_WIDTH = 96;

    private Thumbnail() {}

    static int width(int width) {
        return Math.min(width, MAX_WIDTH);
    }

    /** Returns the height for that of a film, at least 1 pixel. */
    static int height(int width, int height) {
        return Math.clamp(Math.round((double) height * width(width) / width), 1, height);
    }

    static long pixels(PictureSettings picture) {
        return (long) width(picture.width()) * height(picture.width(), picture.height());
    }

    /** Returns a film in which each pixel is the mean of those that it covers. */
    static Film of(Film film) {
        int width = width(film.width());
        int height = height(film.width(), film.height());
        float[] from = film.toScanlines();
        float[] to = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                average(film, from, cell(x, width, film.width()), cell(x + 1, width, film.width()), cell(y, height, film.height()),
                        cell(y + 1, height, film.height()), to, 3 * (y * width + x));
            }
        }
        return Film.ofScanlines(width, height, to);
    }

    private static int cell(int index, int count, int pixels) {
        return (int) ((long) index * pixels / count);
    }

    private static void average(Film film, float[] from, int left, int right, int top, int bottom, float[] to, int at) {
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int y = top; y < bottom; y++) {
                for (int x = left; x < right; x++) {
                    sum += from[3 * (y * film.width() + x) + c];
                }
            }
            to[at + c] = (float) (sum / ((right - left) * (bottom - top)));
        }
    }
}
