package lightning.render.relight;

import lightning.render.image.Film;

/** Error measures between two films. */
public final class FilmError {
    private FilmError() {}

    /** Returns the largest difference of two values, linear. */
    public static double largestError(Film actual, Film expected) {
        float[] a = actual.toScanlines();
        float[] e = expected.toScanlines();
        double largest = 0;
        for (int i = 0; i < a.length; i++) {
            double error = Math.abs((double) a[i] - e[i]);
            if (!(error <= Double.MAX_VALUE)) {
                throw new AssertionError("value " + i + " is " + a[i] + ", expected " + e[i]);
            }
            largest = Math.max(largest, error);
        }
        return largest;
    }

    /** Returns the largest difference as displayed at exposure 0, in 8-bit steps before rounding. */
    static double largestStep(Film actual, Film expected) {
        float[] a = actual.toScanlines();
        float[] e = expected.toScanlines();
        double largest = 0;
        for (int i = 0; i < a.length; i++) {
            largest = Math.max(largest, Math.abs(srgb(a[i]) - srgb(e[i])) * 255);
        }
        return largest;
    }

    private static double srgb(double v) {
        double c = Math.min(v, 1);
        return c <= 0.0031308 ? 12.92 * c : 1.055 * Math.pow(c, 1 / 2.4) - 0.055;
    }
}
