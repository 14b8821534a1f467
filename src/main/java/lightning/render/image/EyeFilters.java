package lightning.render.image;

/**
 * Filters of {@link Flip} for a number of pixels per degree of the visual field: the eye's blur for each opponent channel (contrast
 * sensitivity), and the edge and point detectors.
 *
 * <p>All filters are separable: one factor across and one down, each {@code double[2 * radius + 1]}. The published constants are
 * those of Andersson et al. 2020, table 1 (contrast sensitivity, from Johnson and Fairchild) and section 4.2 (0.082 degrees from
 * peak to trough of the edge detector).
 */
final class EyeFilters {
    /** Degrees from the peak of the edge detector to its trough: two standard deviations of its Gaussian. */
    private static final double PEAK_TO_TROUGH = 0.082;
    /** b of the contrast sensitivity {@code a·√(π/b)·exp(−π²·d²/b)} at d degrees: light, red-green, two of blue-yellow. */
    private static final double LIGHT_B = 0.0047;
    private static final double RED_GREEN_B = 0.0053;
    private static final double[] BLUE_YELLOW_A = {34.1, 13.5};
    private static final double[] BLUE_YELLOW_B = {0.04, 0.025};

    /** Weights with sum 1, for each of these. */
    final double[] light;
    final double[] redGreen;
    /** Two blurs to add; the sum of each is the square root of its share. */
    final double[][] blueYellow;
    /** Weights with sum 1. */
    final double[] gauss;
    /** Weights whose positive part sums to 1 and whose negative part sums to −1. */
    final double[] edge;
    /** Weights whose positive part sums to 1 and whose negative part sums to −1. */
    final double[] point;
    /** Largest radius of all filters, in pixels. */
    final int radius;

    EyeFilters(double pixelsPerDegree) {
        int blur = (int) Math.ceil(3 * Math.sqrt(BLUE_YELLOW_B[0] / (2 * Math.PI * Math.PI)) * pixelsPerDegree);
        light = sensitivity(blur, LIGHT_B, pixelsPerDegree, 1);
        redGreen = sensitivity(blur, RED_GREEN_B, pixelsPerDegree, 1);
        blueYellow = blueYellow(blur, pixelsPerDegree);
        double deviation = 0.5 * PEAK_TO_TROUGH * pixelsPerDegree;
        int feature = (int) Math.ceil(3 * deviation);
        double[] bell = new double[2 * feature + 1];
        double[] slope = new double[2 * feature + 1];
        double[] bend = new double[2 * feature + 1];
        for (int i = -feature; i <= feature; i++) {
            double g = Math.exp(-i * i / (2 * deviation * deviation));
            bell[i + feature] = g;
            slope[i + feature] = -i * g;
            bend[i + feature] = (i * i / (deviation * deviation) - 1) * g;
        }
        gauss = normalized(bell);
        edge = normalized(slope);
        point = normalized(bend);
        radius = Math.max(blur, feature);
    }

    private static double[][] blueYellow(int radius, double pixelsPerDegree) {
        double[] shares = new double[2];
        for (int i = 0; i < 2; i++) {
            double side = sum(bell(radius, BLUE_YELLOW_B[i], pixelsPerDegree));
            shares[i] = BLUE_YELLOW_A[i] * Math.sqrt(Math.PI / BLUE_YELLOW_B[i]) * side * side;
        }
        double all = shares[0] + shares[1];
        return new double[][] {
            sensitivity(radius, BLUE_YELLOW_B[0], pixelsPerDegree, Math.sqrt(shares[0] / all)),
            sensitivity(radius, BLUE_YELLOW_B[1], pixelsPerDegree, Math.sqrt(shares[1] / all))
        };
    }

    private static double[] bell(int radius, double b, double pixelsPerDegree) {
        double[] bell = new double[2 * radius + 1];
        for (int i = -radius; i <= radius; i++) {
            double degrees = i / pixelsPerDegree;
            bell[i + radius] = Math.exp(-Math.PI * Math.PI * degrees * degrees / b);
        }
        return bell;
    }

    private static double[] sensitivity(int radius, double b, double pixelsPerDegree, double sum) {
        double[] bell = bell(radius, b, pixelsPerDegree);
        double factor = sum / sum(bell);
        double[] weights = new double[bell.length];
        for (int i = 0; i < bell.length; i++) {
            weights[i] = bell[i] * factor;
        }
        return weights;
    }

    /** Scales weights so that the positive ones sum to 1 and the negative ones, if any, to −1. */
    private static double[] normalized(double[] weights) {
        double positive = 0;
        double negative = 0;
        for (double weight : weights) {
            positive += Math.max(weight, 0);
            negative -= Math.min(weight, 0);
        }
        double[] balanced = new double[weights.length];
        for (int i = 0; i < weights.length; i++) {
            balanced[i] = weights[i] / (weights[i] < 0 ? negative : positive);
        }
        return balanced;
    }

    private static double sum(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value;
        }
        return sum;
    }
}
