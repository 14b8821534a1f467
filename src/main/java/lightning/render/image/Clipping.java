package lightning.render.image;

/**
 * What a display cuts off: a film is not clamped, 8 bits are.
 *
 * @param clippedPixels    pixels that hold a value above display white
 * @param totalPixels       pixels of the film
 * @param brightest the film's brightest value over display white; 1 is white itself
 */
public record Clipping(long clippedPixels, long totalPixels, double brightest) {

    /** Counts what a view transform clamps at white. */
    public static Clipping of(Film film, ViewTransform view) {
        float gain = view.gain();
        double white = view.curve().white();
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
