package lightning.render.image;

/**
 * Makes films smaller: each pixel is the mean of those that it covers.
 *
 * @param width  of what comes of it, pixels; likewise {@code height}
 */
public record Downscale(int width, int height) {
    /**
     * To the largest size of the same shape, to the pixel, that has room; never to a larger one.
     *
     * @param width     of the picture, pixels; likewise {@code height}
     * @param mostWidth the room, pixels, ≥ 1; likewise {@code mostHeight}
     */
    public static Downscale into(int width, int height, int mostWidth, int mostHeight) {
        double shrink = Math.min(1, Math.min((double) mostHeight / height, (double) mostWidth / width));
        return new Downscale(side(width * shrink), side(height * shrink));
    }

    private static int side(double pixels) {
        return (int) Math.max(1, Math.rint(pixels));
    }

    /** A film of this size, or a smaller one as it is. */
    public Film of(Film film) {
        if (film.width() <= width && film.height() <= height) {
            return film;
        }
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                mean(film, x, y, rgb);
            }
        }
        return Film.ofScanlines(width, height, rgb);
    }

    private void mean(Film film, int x, int y, float[] rgb) {
        int left = from(x, film.width(), width);
        int right = Math.max(left + 1, from(x + 1, film.width(), width));
        int top = from(y, film.height(), height);
        int bottom = Math.max(top + 1, from(y + 1, film.height(), height));
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int v = top; v < bottom; v++) {
            for (int u = left; u < right; u++) {
                red += film.red(u, v);
                green += film.green(u, v);
                blue += film.blue(u, v);
            }
        }
        double share = 1.0 / ((right - left) * (bottom - top));
        int at = 3 * (y * width + x);
        rgb[at] = (float) (red * share);
        rgb[at + 1] = (float) (green * share);
        rgb[at + 2] = (float) (blue * share);
    }

    private static int from(int pixel, int large, int small) {
        return (int) ((long) pixel * large / small);
    }
}
