package lightning.render.match;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/**
 * Finds lights with which a picture comes closest to a reference: factors of their light by a {@link LinearMatch}, and what is not linear by
 * a {@link LightSearch} before.
 */
public final class LightMatch {
    /** Cosine between two images above which noise of a reference decides between their lights. */
    private static final double ALIKE = 0.999;

    private LightMatch() {}

    /**
     * Matches a reference.
     *
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param progress counts lights, then steps of a search
     * @throws IllegalArgumentException if no pixel of the reference counts
     * @throws CancellationException    if {@code progress} requested cancellation
     */
    public static MatchResult of(PixelCache cache, RenderOptions options, ReferenceImage reference, MatchSettings settings,
            Progress progress) {
        return of(MatchContributions.of(cache, options, progress), cache, options, reference, settings, progress);
    }

    /**
     * Matches a reference by contributions that are known.
     *
     * @param contributions contributions to the cached picture; other parameters and exceptions as above
     */
    public static MatchResult of(MatchContributions contributions, PixelCache cache, RenderOptions options, ReferenceImage reference,
            MatchSettings settings, Progress progress) {
        MatchResult linear = linear(contributions, cache, reference, settings);
        if (!settings.isSearch()) {
            return linear;
        }
        Scene scene = cache.scene();
        Scene found;
        try (LightSearch search = new LightSearch(scene, options, reference, settings, progress)) {
            found = search.best();
        }
        Scene moved = scene.withLights(found.lights()).withWorld(found.world());
        try (Renderer renderer = new Renderer(options)) {
            renderer.restore(cache);
            renderer.render(moved, progress.cancellationOnly());
            MatchResult result = linear(
                    MatchContributions.of(renderer.cache(), options, progress.cancellationOnly()),
                    renderer.cache(), reference, settings);
            return result.errorAfter() >= linear.errorAfter() ? linear
                    : new MatchResult(Optional.of(moved), result.factors(), linear.errorBefore(), result.errorAfter(), result.exposure(),
                            result.alike(), result.unseen());
        }
    }

    private static MatchResult linear(MatchContributions contributions, PixelCache cache, ReferenceImage reference,
            MatchSettings settings) {
        MatchImages images =
                MatchImages.of(contributions, contributions.grid().of(cache.film()), settings.lights());
        LinearMatch match = new LinearMatch(images, List.of(), TargetCells.all(reference, images.grid()), settings);
        int lights = images.names().size();
        double[][] after = match.solveSparsely();
        List<LightFactor> factors = IntStream.range(0, lights)
                .mapToObj(l -> new LightFactor(images.names().get(l), after[0][l], after[1][l], after[2][l])).toList();
        List<Double> scale = IntStream.range(0, 3).mapToObj(c -> -after[c][lights + 1]).toList();
        return new MatchResult(Optional.empty(), factors, match.countingError(match.unchanged()), match.countingError(after), scale,
                alike(images.names(), match.products()), images.unseen());
    }

    private static List<MatchResult.LightPair> alike(List<Contribution> names, ImageProducts products) {
        List<MatchResult.LightPair> pairs = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            for (int j = i + 1; j < names.size(); j++) {
                if (products.cosine(i, j) > ALIKE) {
                    pairs.add(new MatchResult.LightPair(names.get(i), names.get(j)));
                }
            }
        }
        return pairs;
    }
}
