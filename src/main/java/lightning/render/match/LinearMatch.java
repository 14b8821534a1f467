package lightning.render.match;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import lightning.scene.Contribution;

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
    private final int changes;
    private final TargetCells target;
    private final MatchSettings settings;
    private final ImageProducts products;

    /** @param changes {@code float[channel][cell]} of each D */
    LinearMatch(MatchImages images, List<float[][]> changes, TargetCells target, MatchSettings settings) {
        this.images = images;
        this.changes = changes.size();
        this.target = target;
        this.settings = settings;
        List<float[][]> all = new ArrayList<>(images.lights());
        all.addAll(changes);
        all.add(images.rest());
        all.add(target.values());
        products = ImageProducts.of(all, target.weights());
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
        FactorProblem problem = problem();
        int lights = images.names().size();
        for (int l = 0; l < lights; l++) {
            boolean isEnvironment = images.names().get(l).equals(Contribution.ENVIRONMENT);
            problem.addLight(l, TargetCells.means(images.lights().get(l)),
                    settings.changes().contains(MatchChange.COLORS) && !isEnvironment);
        }
        IntStream.range(lights, lights + changes).forEach(d -> problem.addStep(d, limit));
        return problem.solve();
    }

    /** Returns a problem in which all but lights and changes are known. */
    private FactorProblem problem() {
        int known = images.names().size() + changes;
        FactorProblem problem = new FactorProblem(products, known + 2, settings.steadiness());
        problem.fix(known, 1);
        if (settings.referenceFactors() == 0) {
            problem.fix(known + 1, -1);
        } else {
            problem.addReference(known + 1, settings.referenceFactors());
        }
        return problem;
    }

    /** Returns the weighted root mean square of the difference, relative to the reference as it is scaled. */
    double error(double[][] factors) {
        int reference = factors[0].length - 1;
        double scale = TargetCells.luminance(factors[0][reference], factors[1][reference], factors[2][reference]);
        return scale == 0 ? 1 : Math.sqrt(products.squares(factors) / target.total()) / Math.abs(scale);
    }
}
