package lightning.render.match;

import java.util.stream.IntStream;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Finds the light that a view transform shows as given display colors, by the secant method on the logarithms of the channels. Views that mix
 * channels show no light in some colors, and more than one in none.
 */
final class InverseView {
    private static final int MAX_STEPS = 40;
    /** Differences of 16-bit codes: an eighth of an 8-bit step ends the search; a whole one is another color. */
    private static final int CLOSE = 32;
    private static final int OTHER = 257;
    private static final double CODES = 65535;
    /** Keeps logarithms of black finite: less than the light of the first 16-bit code. */
    private static final double BLACK = 1e-7;
    /** Slope of codes over light, both as logarithms: that of sRGB is about 1/2.2. */
    private static final double FIRST_SLOPE = 0.6;
    private static final double MIN_SLOPE = 0.1;
    private static final double MAX_SLOPE = 5;

    private final ViewTransform view;
    private final short[] codes = new short[3];
    private final double[] wanted = new double[3];
    private final double[] light = new double[3];
    private final double[] logLight = new double[3];
    private final double[] lastLog = new double[3];
    private final double[] lastShown = new double[3];
    private final double[] slope = new double[3];

    private InverseView(ViewTransform view) {
        this.view = view;
    }

    /**
     * Returns an image's light before a view transform.
     *
     * @param reference light that {@link ViewTransform#DEFAULT} shows as the image
     * @return the same image with light that {@code view} shows as the image; pixels whose colors the view cannot show do not count
     */
    static ReferenceImage apply(ReferenceImage reference, ViewTransform view) {
        Film film = reference.film();
        float[] rgb = film.toScanlines();
        float[] weights = reference.weights().clone();
        IntStream.range(0, film.height()).parallel().forEach(y -> {
            var inverse = new InverseView(view);
            for (int i = y * film.width(); i < (y + 1) * film.width(); i++) {
                if (weights[i] > 0 && !inverse.find(rgb, 3 * i)) {
                    weights[i] = 0;
                }
            }
        });
        return new ReferenceImage(Film.ofScanlines(film.width(), film.height(), rgb), weights);
    }

    /** Replaces a color by the light that the view shows as this color; returns false if there is none. */
    private boolean find(float[] rgb, int at) {
        ViewTransform.DEFAULT.pack16(rgb[at], rgb[at + 1], rgb[at + 2], codes, 0);
        int[] target = {codes[0] & 0xffff, codes[1] & 0xffff, codes[2] & 0xffff};
        for (int c = 0; c < 3; c++) {
            wanted[c] = Math.log(target[c] / CODES + BLACK);
            logLight[c] = Math.log(Math.max(rgb[at + c], BLACK) / view.gain());
            slope[c] = FIRST_SLOPE;
        }
        int difference = Integer.MAX_VALUE;
        for (int step = 0; step < MAX_STEPS && difference > CLOSE; step++) {
            for (int c = 0; c < 3; c++) {
                light[c] = Math.exp(logLight[c]);
            }
            view.pack16((float) light[0], (float) light[1], (float) light[2], codes, 0);
            difference = 0;
            for (int c = 0; c < 3; c++) {
                int code = codes[c] & 0xffff;
                difference = Math.max(difference, Math.abs(code - target[c]));
                improve(c, Math.log(code / CODES + BLACK), step);
            }
        }
        for (int c = 0; c < 3; c++) {
            rgb[at + c] = (float) light[c];
        }
        return difference <= OTHER;
    }

    /** Sets the next logarithm of a channel. */
    private void improve(int c, double shown, int step) {
        double moved = logLight[c] - lastLog[c];
        if (step > 0 && Math.abs(moved) > 1e-9) {
            slope[c] = Math.clamp((shown - lastShown[c]) / moved, MIN_SLOPE, MAX_SLOPE);
        }
        lastLog[c] = logLight[c];
        lastShown[c] = shown;
        logLight[c] += Math.clamp((wanted[c] - shown) / slope[c], -3, 3);
    }
}
