package lightning.render.measure;

import java.util.Arrays;
import lightning.base.text.RefusalException;
import lightning.render.image.Film;

/**
 * Errors of luminances against a reference, sorted. An error is relative to the larger of the reference and 5 % of its mean, so that dark
 * places count little; a value that should be black has the error 1.
 */
record RelativeErrors(double[] sorted) {
    private static final double DARK = 0.05;

    /**
     * Compares luminances, 0…
     *
     * @throws IllegalArgumentException if there is none
     */
    static RelativeErrors of(double[] light, double[] reference) {
        if (light.length == 0) {
            throw new RefusalException("expected at least one pixel that shows a surface, found none");
        }
        double floor = DARK * Arrays.stream(reference).sum() / reference.length;
        double[] errors = new double[light.length];
        for (int i = 0; i < light.length; i++) {
            double scale = Math.max(reference[i], floor);
            errors[i] = scale > 0 ? Math.abs(light[i] - reference[i]) / scale : light[i] > 0 ? 1 : 0;
        }
        Arrays.sort(errors);
        return new RelativeErrors(errors);
    }

    /** Returns the luminances of a picture's pixels, line by line from the top. */
    static double[] luminances(Film film) {
        double[] values = new double[film.width() * film.height()];
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                values[y * film.width() + x] = BruteForceGather.luminance(film.red(x, y), film.green(x, y), film.blue(x, y));
            }
        }
        return values;
    }

    double mean() {
        return Arrays.stream(sorted).average().orElseThrow();
    }

    /** Returns the error that this share of the values does not exceed. */
    double percentile(double share) {
        return sorted[(int) (share * sorted.length)];
    }
}
