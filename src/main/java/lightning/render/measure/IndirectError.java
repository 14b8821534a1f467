package lightning.render.measure;

import java.util.Arrays;

/**
 * Errors of an image's indirect light at sampled pixels, against brute force ({@link RelativeErrors}).
 *
 * @param mean    mean error, 0…
 * @param median  median error
 * @param high    95th percentile of the errors
 * @param bias    difference of the sums of all pixels, relative to the reference; negative if too dark
 * @param missing share of the light of eight bounces that the setting's number of bounces does not contain, by brute force
 */
public record IndirectError(double mean, double median, double high, double bias, double missing) {
    /** Share of the pixels below {@link #high}. */
    static final double HIGH = 0.95;
    private static final double MEDIAN = 0.5;

    /**
     * Compares luminances per pixel.
     *
     * @param light   of the image
     * @param exact   of the reference with as many bounces
     * @param complete of the reference with all bounces
     * @throws IllegalArgumentException if there is no pixel
     */
    static IndirectError of(double[] light, double[] exact, double[] complete) {
        RelativeErrors errors = RelativeErrors.of(light, exact);
        double total = Arrays.stream(exact).sum();
        double all = Arrays.stream(complete).sum();
        return new IndirectError(errors.mean(), errors.percentile(MEDIAN), errors.percentile(HIGH),
                ratio(Arrays.stream(light).sum() - total, total), ratio(all - total, all));
    }

    private static double ratio(double part, double whole) {
        return whole > 0 ? part / whole : 0;
    }
}
