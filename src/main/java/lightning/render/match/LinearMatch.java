package lightning.render.match;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import lightning.scene.SceneElement;

/**
 * Finds factors of images with which their sum comes closest to a reference:
 *
 * <pre>
 * minimize Σ w·(Σ f·L + Σ s·D + R − e·T)²   with f ≥ 0 and |s| ≤ a limit
 * </pre>
 *
 * <p>L are the contributions of the lights, D are changes of a contribution along numbers of a light, R is all other light, T is the
 * reference, and e its scale: 1, or unknown if its exposure or white balance is free. Then the mean brightness of the lights stays.
 */
final class LinearMatch {
    private final MatchImages images;
    /** Change of a light, relative to the largest, up to which paint leaves the light as it is. */
    private static final double SMALL = 0.1;
    /** Weight of pixels without paint while the amount of all changes is chosen. */
    private static final double STAY = 0.1;
    private static final double MAX_AMOUNT = 4;

    private final int changes;
    private final double total;
    private final double countingTotal;
    private final MatchSettings settings;
    /** Products where the reference counts, and together with those where the picture shall stay. */
    private final ImageProducts counting;
    private final ImageProducts products;
    private final boolean isPainted;

    /**
     * @param changes {@code float[channel][cell]} of each D
     * @param targets cells of the reference, and those that shall stay, if there are any
     */
    LinearMatch(MatchImages images, List<float[][]> changes, List<TargetCells> targets, MatchSettings settings) {
        this.images = images;
        this.changes = changes.size();
        this.settings = settings;
        List<float[][]> all = new ArrayList<>(images.lights());
        all.addAll(changes);
        all.add(images.rest());
        List<ImageProducts> ofTargets = targets.stream().map(target -> products(all, target)).toList();
        counting = ofTargets.getFirst();
        countingTotal = targets.getFirst().total();
        isPainted = targets.size() > 1;
        products = isPainted ? counting.plus(ofTargets.getLast()) : counting;
        total = targets.stream().mapToDouble(TargetCells::total).sum();
    }

    private static ImageProducts products(List<float[][]> images, TargetCells target) {
        List<float[][]> all = new ArrayList<>(images);
        all.add(target.values());
        return ImageProducts.of(all, target.weights());
    }

    ImageProducts products() {
        return products;
    }

    /** Returns the factors of all images while lights are as they are: only the scale of the reference is unknown. */
    double[][] unchanged() {
        FactorProblem problem = problem();
        for (int l = 0; l < images.names().size(); l++) {
            problem.fix(l, 1);
        }
        for (int d = 0; d < changes; d++) {
            problem.fix(images.names().size() + d, 0);
        }
        return problem.solve();
    }

    /**
     * Returns the best factors of all images, {@code double[channel][image]}: of lights, changes, 1 for the rest, and the negative scale of
     * the reference.
     *
     * @param limit largest factor of a change
     */
    double[][] solve(double limit) {
        return solve(limit, _ -> true);
    }

    private double[][] solve(double limit, IntPredicate mayChange) {
        FactorProblem problem = problem();
        int lights = images.names().size();
        for (int l = 0; l < lights; l++) {
            if (!mayChange.test(l)) {
                problem.fix(l, 1);
                continue;
            }
            boolean isEnvironment = !(images.names().get(l) instanceof SceneElement.OfLight);
            problem.addLight(l, TargetCells.means(images.lights().get(l)),
                    settings.changes().contains(MatchChange.COLORS) && !isEnvironment);
        }
        IntStream.range(lights, lights + changes).forEach(d -> problem.addStep(d, limit));
        return problem.solve();
    }

    /**
     * Returns the factors of all images that the reference asks for. What shall stay decides which lights change: those that light paint more than other
     * places, unless they change little. The paint decides how much they do.
     */
    double[][] solveSparsely() {
        double[][] all = solve(0);
        if (!isPainted) {
            return all;
        }
        double[] effects = IntStream.range(0, images.names().size()).mapToDouble(l -> effect(l, all)).toArray();
        double largest = Arrays.stream(effects).max().orElse(0);
        double[][] few = solve(0, l -> effects[l] >= SMALL * largest);
        return scaled(few, amount(few));
    }

    /** Returns the root of the weighted squares of the change of a light. */
    private double effect(int light, double[][] factors) {
        return Math.sqrt(IntStream.range(0, 3).mapToDouble(c -> Math.pow(factors[c][light] - 1, 2) * products.of(c, light, light)).sum());
    }

    /** Returns the multiple of all changes, at least 1, with which painted pixels come closest to the reference, and others stay. */
    private double amount(double[][] factors) {
        double[] errors = IntStream.range(0, 3).mapToDouble(amount -> {
            double[][] changed = scaled(factors, amount);
            return (1 - STAY) * counting.squares(changed) + STAY * products.squares(changed);
        }).toArray();
        double curvature = errors[2] - 2 * errors[1] + errors[0];
        double slope = errors[1] - errors[0] - curvature / 2;
        double nonNegative = Arrays.stream(factors).flatMapToDouble(channel -> Arrays.stream(channel, 0, images.names().size()))
                .filter(factor -> factor < 1).map(factor -> 1 / (1 - factor)).min().orElse(MAX_AMOUNT);
        return curvature <= 0 ? 1 : Math.clamp(-slope / curvature, 1, Math.max(1, Math.min(MAX_AMOUNT, nonNegative)));
    }

    private double[][] scaled(double[][] factors, double amount) {
        double[][] scaled = new double[3][];
        for (int c = 0; c < 3; c++) {
            scaled[c] = factors[c].clone();
            for (int l = 0; l < images.names().size(); l++) {
                scaled[c][l] = 1 + amount * (factors[c][l] - 1);
            }
        }
        return scaled;
    }

    /** Returns a problem in which all but lights and changes are known. */
    private FactorProblem problem() {
        int known = images.names().size() + changes;
        FactorProblem problem = new FactorProblem(products, known + 2, settings.steadiness());
        problem.fix(known, 1);
        if (isPainted) {
            problem.changeFew();
        }
        if (settings.referenceFactors() == 0) {
            problem.fix(known + 1, -1);
        } else {
            problem.addReference(known + 1, settings.referenceFactors());
        }
        return problem;
    }

    /** Returns the weighted root mean square of the difference, relative to the reference as it is scaled; with that of what shall stay. */
    double error(double[][] factors) {
        return error(factors, products, total);
    }

    /** Returns the same without what shall stay. */
    double countingError(double[][] factors) {
        return error(factors, counting, countingTotal);
    }

    private static double error(double[][] factors, ImageProducts products, double total) {
        int reference = factors[0].length - 1;
        double scale = TargetCells.luminance(factors[0][reference], factors[1][reference], factors[2][reference]);
        return scale == 0 ? 1 : Math.sqrt(products.squares(factors) / total) / Math.abs(scale);
    }
}
