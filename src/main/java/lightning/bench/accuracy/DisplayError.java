package lightning.bench.accuracy;

import lightning.render.image.Film;

/** Visible error of an image against one with many samples. */
public final class DisplayError {
    private DisplayError() {}

    /**
     * Returns the root mean square difference of the square roots of all values, each clamped to 0…1 before. The square root approximates
     * the display's encoding, so that errors in dark and bright areas count about as much as they are visible.
     *
     * @throws IllegalArgumentException if the sizes differ
     */
    public static double of(Film film, Film reference) {
        if (film.width() != reference.width() || film.height() != reference.height()) {
            throw new IllegalArgumentException("expected images of one size, found " + film.width() + "x" + film.height() + " and "
                    + reference.width() + "x" + reference.height());
        }
        float[] values = film.toScanlines();
        float[] expected = reference.toScanlines();
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
            double difference = encoded(values[i]) - encoded(expected[i]);
            sum += difference * difference;
        }
        return Math.sqrt(sum / values.length);
    }

    private static double encoded(float linear) {
        return Math.sqrt(Math.clamp(linear, 0f, 1f));
    }
}
