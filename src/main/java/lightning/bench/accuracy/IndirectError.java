package lightning.bench.accuracy;

import java.util.Arrays;

/**
 * Errors of an image's indirect light at sampled pixels, against brute force. An error is relative to the larger of the reference and 5 % of
 * its mean, so that dark places count little.
 *
 * @param mean    mean error, 0…
 * @param median  median error
 * @param high    95th percentile of the errors
 * @param bias    difference of the sums of all pixels, relative to the reference; negative if too dark
 * @param missing share of the light of eight bounces that the setting's number of bounces does not contain, by brute force
 */
public record IndirectError(double mean, double median, double high, double bias, double missing) {
    private static final double DARK = 0.05;
    private static final double HIGH = 0.95;

    /**
     * Compares luminances per pixel.
     *
     * @param light   of the image
     * @param exact   of the reference with as many bounces
     * @param complete of the reference with all bounces
     * @throws IllegalArgumentException if there is no pixel
     */
    static IndirectError of(double[] light, double[] exact, double[] complete) {
        if (light.length == 0) {
            throw new IllegalArgumentException("expected at least one pixel that shows a surface, found none");
        }
        double total = Arrays.stream(exact).sum();
        double floor = DARK * total / exact.length;
        double[] errors = new double[light.length];
        for (int i = 0; i < light.length; i++) {
            double scale = Math.max(exact[i], floor);
            errors[i] = scale > 0 ? Math.abs(light[i] - exact[i]) / scale : light[i] > 0 ? 1 : 0;
        }
        Arrays.sort(errors);
        double all = Arrays.stream(complete).sum();
        return new IndirectError(Arrays.stream(errors).average().orElseThrow(), errors[errors.length / 2],
                errors[(int) (HIGH * errors.length)], ratio(Arrays.stream(light).sum() - total, total), ratio(all - total, all));
    }

    private static double ratio(double part, double whole) {
        return whole > 0 ? part / whole : 0;
    }
}
