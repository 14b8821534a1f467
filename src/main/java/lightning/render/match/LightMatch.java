package lightning.render.match;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.relight.LightContributions;
import lightning.render.relight.tile.RenderOptions;

/**
 * Finds the factors of lights with which a picture comes closest to a reference:
 *
 * <pre>
 * minimize Σ w·(Σ f·L + R − e·T)²   with f ≥ 0
 * </pre>
 *
 * <p>L are the contributions of the lights, R is all other light, T is the reference, and e its scale: 1, or unknown if its exposure or white
 * balance is free. Then the mean brightness of the lights stays. A pixel's weight w is its own, divided by the square of the reference's
 * luminance plus a twentieth of its mean: relative differences count, as eyes see them. Pixels with finer samples do not count.
 */
public final class LightMatch {
    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};
    /** Share of the mean luminance that is added to each: darker pixels count as absolute differences. */
    private static final double FLOOR = 0.05;
    /** Cosine between two images above which noise of a reference decides between their lights. */
    private static final double ALIKE = 0.999;

    private final MatchImages images;
    private final ImageProducts products;
    private final double[] weights;
    /** Sum of the pixels' own weights, of all channels. */
    private final double weight;

    /**
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param progress counts lights
     * @throws IllegalArgumentException if no pixel of the reference counts
     * @throws CancellationException    if {@code progress} requested cancellation
     */
    private LightMatch(PixelCache cache, RenderOptions options, ReferenceImage reference, MatchSettings settings, Progress progress) {
        images = MatchImages.of(cache, options, settings.lights(), progress);
        PixelMeans.Means target = images.grid().of(reference.film(), reference.weights());
        images.skipped().stream().forEach(i -> target.weights()[i] = 0);
        weights = new double[target.weights().length];
        double sum = 0;
        double total = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += target.weights()[i] * luminance(target.values(), i);
            total += target.weights()[i];
        }
        if (total == 0) {
            throw new IllegalArgumentException("no pixel of the reference counts");
        }
        for (int i = 0; i < weights.length; i++) {
            double unit = luminance(target.values(), i) + FLOOR * sum / total;
            weights[i] = unit == 0 ? target.weights()[i] : target.weights()[i] / (unit * unit);
        }
        List<float[][]> all = new ArrayList<>(images.lights());
        all.add(images.rest());
        all.add(target.values());
        products = ImageProducts.of(all, weights);
        weight = 3 * total;
    }

    /**
     * Matches a reference.
     *
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param progress counts lights
     * @throws IllegalArgumentException if no pixel of the reference counts
     * @throws CancellationException    if {@code progress} requested cancellation
     */
    public static MatchResult of(PixelCache cache, RenderOptions options, ReferenceImage reference, MatchSettings settings,
            Progress progress) {
        return new LightMatch(cache, options, reference, settings, progress).solve(settings);
    }

    private static double luminance(float[][] image, int i) {
        return LUMINANCE[0] * image[0][i] + LUMINANCE[1] * image[1][i] + LUMINANCE[2] * image[2][i];
    }

    private MatchResult solve(MatchSettings settings) {
        int lights = images.names().size();
        double[][] before = problem(settings, false).solve();
        double[][] after = problem(settings, true).solve();
        List<LightFactor> factors = IntStream.range(0, lights)
                .mapToObj(l -> new LightFactor(images.names().get(l), after[0][l], after[1][l], after[2][l])).toList();
        List<Double> scale = IntStream.range(0, 3).mapToObj(c -> -after[c][lights + 1]).toList();
        return new MatchResult(factors, error(before), error(after), scale, alike(), images.unseen());
    }

    /** @param changes whether the lights may change; otherwise only the scale of the reference is unknown */
    private FactorProblem problem(MatchSettings settings, boolean changes) {
        int lights = images.names().size();
        FactorProblem problem = new FactorProblem(products, lights + 2, settings.steadiness());
        for (int l = 0; l < lights; l++) {
            if (changes) {
                boolean isEnvironment = images.names().get(l).equals(LightContributions.ENVIRONMENT);
                problem.addLight(l, means(images.lights().get(l)), settings.colors() && !isEnvironment);
            } else {
                problem.fix(l, 1);
            }
        }
        problem.fix(lights, 1);
        if (settings.referenceFactors() == 0) {
            problem.fix(lights + 1, -1);
        } else {
            problem.addReference(lights + 1, settings.referenceFactors());
        }
        return problem;
    }

    private double[] means(float[][] image) {
        double[] means = new double[3];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < weights.length; i++) {
                means[c] += LUMINANCE[c] * image[c][i] / weights.length;
            }
        }
        return means;
    }

    /** Returns the weighted root mean square of the difference, relative to the reference as it is scaled. */
    private double error(double[][] factors) {
        int reference = factors[0].length - 1;
        double scale = LUMINANCE[0] * factors[0][reference] + LUMINANCE[1] * factors[1][reference] + LUMINANCE[2] * factors[2][reference];
        return scale == 0 ? 1 : Math.sqrt(products.squares(factors) / weight) / Math.abs(scale);
    }

    private List<MatchResult.LightPair> alike() {
        List<MatchResult.LightPair> pairs = new ArrayList<>();
        for (int i = 0; i < images.names().size(); i++) {
            for (int j = i + 1; j < images.names().size(); j++) {
                if (cosine(i, j) > ALIKE) {
                    pairs.add(new MatchResult.LightPair(images.names().get(i), images.names().get(j)));
                }
            }
        }
        return pairs;
    }

    /** Returns the cosine of the angle between two images; 0 if one of them is black where pixels count. */
    private double cosine(int i, int j) {
        double[] sums = new double[3];
        for (int c = 0; c < 3; c++) {
            sums[0] += products.of(c, i, j);
            sums[1] += products.of(c, i, i);
            sums[2] += products.of(c, j, j);
        }
        return sums[1] == 0 || sums[2] == 0 ? 0 : sums[0] / Math.sqrt(sums[1] * sums[2]);
    }
}
