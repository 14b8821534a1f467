package lightning.render.relight;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Contribution;

/**
 * Contributions to a picture, one after the other: of each light that shines with its visible face and its bulbs, and of each environment
 * with its visible background. With what remains of the picture they add up to it, apart from rounding, and each follows the weight of its light.
 */
public final class LightFilms {
    private LightFilms() {}

    /** Receiver of contributions. */
    @FunctionalInterface
    public interface Receiver {
        void receive(Contribution contribution, Film film);
    }

    /**
     * Composes contributions from the cache of a picture, over its samples. Casts no ray.
     *
     * @param cache    of a picture, with or without its finer samples
     * @param chosen   selects contributions
     * @param progress counts contributions
     * @throws IllegalStateException if mirror levels are stored as hit shapes
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static void forEach(PixelCache cache, RenderOptions options, Predicate<Contribution> chosen, Progress progress,
            Receiver receiver) {
        List<Contribution> contributions = Contribution.shining(cache.scene()).stream().filter(chosen).toList();
        try (Renderer renderer = new Renderer(options)) {
            renderer.restore(cache);
            for (int l = 0; l < contributions.size(); l++) {
                progress.report(l, contributions.size());
                receiver.receive(contributions.get(l), renderer.contribution(contributions.get(l), progress.cancellationOnly()));
            }
        }
        progress.report(contributions.size(), contributions.size());
    }
}
