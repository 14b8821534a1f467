package lightning.render.image;

/**
 * Clipping of a displayed film: 8-bit codes are clamped, the film is not.
 *
 * @param clippedPixels number of pixels with a value above display white
 * @param totalPixels   number of pixels of the film
 * @param brightest     the film's largest value relative to display white; 1 is white
 */
public record Clipping(long clippedPixels, long totalPixels, double brightest) {

    /** Counts the pixels that a view transform clamps at white. */
    public static Clipping of(Film film, ViewTransform view) {
        float gain = view.gain();
        double white = view.white();
        long clipped = 0;
        float brightest = 0;
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                float max = Math.max(Math.max(film.red(x, y), film.green(x, y)), film.blue(x, y));
                clipped += max * gain > white ? 1 : 0;
                brightest = Math.max(brightest, max);
            }
        }
        return new Clipping(clipped, (long) film.width() * film.height(), (double) brightest * gain / white);
    }
}
