package lightning.render.image;

/**
 * Box filter that makes films smaller: each pixel is the mean of the pixels that it covers.
 *
 * @param width  width of the result in pixels
 * @param height height of the result in pixels
 */
public record Downscale(int width, int height) {
    /**
     * Returns the largest size with the same aspect ratio, to the pixel, that fits; never larger than the image.
     *
     * @param width    width of the image in pixels, with {@code height}
     * @param maxWidth maximum width in pixels, ≥ 1, with {@code maxHeight}
     */
    public static Downscale fit(int width, int height, int maxWidth, int maxHeight) {
        double shrink = Math.min(1, Math.min((double) maxHeight / height, (double) maxWidth / width));
        return new Downscale(side(width * shrink), side(height * shrink));
    }

    private static int side(double pixels) {
        return (int) Math.max(1, Math.rint(pixels));
    }

    /** Returns a film of this size, or the film itself if it is smaller. */
    public Film apply(Film film) {
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
        int left = firstPixel(x, film.width(), width);
        int right = Math.max(left + 1, firstPixel(x + 1, film.width(), width));
        int top = firstPixel(y, film.height(), height);
        int bottom = Math.max(top + 1, firstPixel(y + 1, film.height(), height));
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

    private static int firstPixel(int pixel, int large, int small) {
        return (int) ((long) pixel * large / small);
    }
}
