package lightning.render.match;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.ojalgo.matrix.store.R064Store;
import org.ojalgo.optimisation.Optimisation;
import org.ojalgo.optimisation.convex.ConvexSolver;

/**
 * Non-negative least squares: factors of images whose sum is as small as possible, where some images have fixed factors, and some factors of limited
 * size may be negative. Unknown factors of
 * lights keep their mean brightness if the reference may be scaled, because all would become 0 otherwise.
 */
final class FactorProblem {
    /** Least pull toward a factor of 1, relative to the light's own square: decides between lights that look alike. */
    private static final double PULL = 1e-10;
    /** Pull of steps toward 0, relative to their own square: keeps directions that change nothing still. */
    private static final double STEP_PULL = 1e-6;

    /** Share of the largest resemblance from which on a light changes, if few shall. */
    private static final double FEW = 0.5;

    /**
     * One unknown.
     *
     * @param image index of its image
     * @param first the first channel that it multiplies
     * @param end   the channel after the last
     * @param sign  1, or −1 for the reference
     * @param mean  mean brightness of what it multiplies; 0 for the reference and for steps
     * @param limit largest absolute value of a step; infinite for factors, which are ≥ 0
     */
    private record Unknown(int image, int first, int end, int sign, double mean, double limit) {
        boolean isStep() {
            return limit < Double.POSITIVE_INFINITY;
        }

        boolean overlaps(Unknown other) {
            return first < other.end && other.first < end;
        }

        boolean has(int channel) {
            return channel >= first && channel < end;
        }
    }

    private final ImageProducts products;
    private final int images;
    private final List<Unknown> unknowns = new ArrayList<>();
    /** Factors of images, {@code double[channel][image]}; those of unknowns are 0. */
    private final double[][] fixed;
    private boolean keepsMean;
    private boolean changesFew;
    private final double steadiness;

    /** @param steadiness as in {@link MatchSettings} */
    FactorProblem(ImageProducts products, int images, double steadiness) {
        this.steadiness = steadiness;
        this.products = products;
        this.images = images;
        fixed = new double[3][images];
    }

    /** Gives an image a fixed factor. */
    void fix(int image, double factor) {
        for (double[] channel : fixed) {
            channel[image] = factor;
        }
    }

    /**
     * Makes the factor of a light unknown.
     *
     * @param means  mean brightness of its channels
     * @param colors whether each channel has a factor of its own
     */
    void addLight(int image, double[] means, boolean colors) {
        if (colors) {
            for (int c = 0; c < 3; c++) {
                unknowns.add(new Unknown(image, c, c + 1, 1, means[c], Double.POSITIVE_INFINITY));
            }
        } else {
            unknowns.add(new Unknown(image, 0, 3, 1, means[0] + means[1] + means[2], Double.POSITIVE_INFINITY));
        }
    }

    /** Makes the factor of an image unknown that may be negative. */
    void addStep(int image, double limit) {
        unknowns.add(new Unknown(image, 0, 3, 1, 0, limit));
    }

    /**
     * Lets few lights change: each only as the reference asks for at present, brighter or darker, and only if its light resembles what is missing at least
     * by a share of the light that does most.
     */
    void changeFew() {
        changesFew = true;
    }

    /** Makes the factor of the reference unknown, for all channels or for each. */
    void addReference(int image, int factors) {
        keepsMean = true;
        for (int f = 0; f < factors; f++) {
            unknowns.add(new Unknown(image, factors == 1 ? 0 : f, factors == 1 ? 3 : f + 1, -1, 0, Double.POSITIVE_INFINITY));
        }
    }

    /** Returns the factors of all images with which their sum is smallest: {@code double[channel][image]}, that of the reference negative. */
    double[][] solve() {
        List<Unknown> solved = unknowns.stream().filter(u -> product(u, u) > 0).toList();
        double[] factors = solved.isEmpty() ? new double[0] : solve(solved);
        double[][] all = new double[3][images];
        for (int c = 0; c < 3; c++) {
            all[c] = fixed[c].clone();
        }
        // A channel in which a light is black keeps its factor.
        unknowns.stream().filter(u -> !solved.contains(u)).forEach(u -> set(u, u.isStep() ? 0 : 1, all));
        for (int i = 0; i < factors.length; i++) {
            set(solved.get(i), factors[i], all);
        }
        return all;
    }

    private static void set(Unknown unknown, double factor, double[][] all) {
        for (int c = unknown.first; c < unknown.end; c++) {
            all[c][unknown.image] = unknown.sign * factor;
        }
    }

    private double[] solve(List<Unknown> solved) {
        int count = solved.size();
        double[] scale = solved.stream().mapToDouble(u -> 1 / Math.sqrt(product(u, u))).toArray();
        double largest = solved.stream().mapToDouble(u -> product(u, u)).max().orElse(0);
        R064Store quadratic = R064Store.FACTORY.make(count, count);
        R064Store linear = R064Store.FACTORY.make(count, 1);
        for (int i = 0; i < count; i++) {
            Unknown u = solved.get(i);
            for (int j = 0; j < count; j++) {
                quadratic.set(i, j, scale[i] * scale[j] * product(u, solved.get(j)));
            }
            double pull = u.isStep() ? STEP_PULL * product(u, u) : u.sign > 0 ? PULL * product(u, u) + steadiness * largest : 0;
            quadratic.add(i, i, pull * scale[i] * scale[i]);
            linear.set(i, 0, scale[i] * ((u.isStep() ? 0 : pull) - productWithFixed(u)));
        }
        double[] least = solved.stream().mapToDouble(u -> u.isStep() ? -u.limit : 0).toArray();
        double[] most = solved.stream().mapToDouble(Unknown::limit).toArray();
        if (changesFew) {
            double[] asked = solved.stream().mapToDouble(u -> u.isStep() ? 0 : -productWithPresent(u) / Math.sqrt(product(u, u))).toArray();
            for (int i = 0; i < count; i++) {
                Unknown u = solved.get(i);
                if (!u.isStep()) {
                    double resemblance = FEW
                            * IntStream.range(0, count).filter(j -> solved.get(j).overlaps(u)).mapToDouble(j -> Math.abs(asked[j])).max()
                                    .orElse(0);
                    linear.add(i, 0, asked[i] > 0 ? -resemblance : resemblance);
                    least[i] = asked[i] > 0 ? 1 : 0;
                    most[i] = asked[i] > 0 ? Double.POSITIVE_INFINITY : 1;
                }
            }
        }
        ConvexSolver.Builder problem = ConvexSolver.newBuilder().objective(quadratic, linear);
        int limited = (int) Arrays.stream(most).filter(v -> v < Double.POSITIVE_INFINITY).count();
        R064Store bounds = R064Store.FACTORY.make(count + limited, count);
        R064Store limits = R064Store.FACTORY.make(count + limited, 1);
        int upper = count;
        for (int i = 0; i < count; i++) {
            bounds.set(i, i, -1);
            limits.set(i, 0, -least[i] / scale[i]);
            if (most[i] < Double.POSITIVE_INFINITY) {
                bounds.set(upper, i, 1);
                limits.set(upper++, 0, most[i] / scale[i]);
            }
        }
        problem.inequalities(bounds, limits);
        double total = solved.stream().mapToDouble(Unknown::mean).sum();
        if (keepsMean && total > 0) {
            R064Store means = R064Store.FACTORY.make(1, count);
            for (int i = 0; i < count; i++) {
                means.set(0, i, scale[i] * solved.get(i).mean / total);
            }
            R064Store one = R064Store.FACTORY.make(1, 1);
            one.set(0, 0, 1);
            problem.equalities(means, one);
        }
        Optimisation.Result result = problem.solve();
        double[] factors = new double[count];
        Arrays.setAll(factors, i -> Math.clamp(result.doubleValue(i) * scale[i], least[i], most[i]));
        return factors;
    }

    private double product(Unknown u, Unknown v) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += u.has(c) && v.has(c) ? u.sign * v.sign * products.of(c, u.image, v.image) : 0;
        }
        return sum;
    }

    /** Returns the product with the sum of all images while lights are as they are. */
    private double productWithPresent(Unknown u) {
        return productWithFixed(u) + unknowns.stream().mapToDouble(v -> v.isStep() ? 0 : product(u, v)).sum();
    }

    private double productWithFixed(Unknown u) {
        double sum = 0;
        for (int c = u.first; c < u.end; c++) {
            for (int j = 0; j < images; j++) {
                sum += u.sign * fixed[c][j] * products.of(c, u.image, j);
            }
        }
        return sum;
    }
}
