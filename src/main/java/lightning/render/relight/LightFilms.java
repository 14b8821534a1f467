package lightning.render.relight;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/**
 * Contributions of the lights to a picture, one after the other: of each light that shines, and of the environment with its visible
 * background. With what remains of the picture they add up to it, apart from rounding.
 */
public final class LightFilms {
    private LightFilms() {}

    /** Receiver of contributions. */
    @FunctionalInterface
    public interface Receiver {
        /** @param light name of the light, {@link LightContributions#ENVIRONMENT} for the environment */
        void receive(String light, Film contribution);
    }

    /** Returns the names of all lights that shine, in the scene's order; the environment comes last. */
    public static List<String> names(Scene scene) {
        boolean hasEnvironment = scene.rig().isEnvironmentActive() && scene.world().hasEnvironmentLight();
        return Stream.concat(scene.lights().stream().filter(scene::isActive).map(Light::name),
                hasEnvironment ? Stream.of(LightContributions.ENVIRONMENT) : Stream.empty()).toList();
    }

    /**
     * Composes contributions from the cache of a picture. Casts no ray, except for finer samples where the environment has an edge.
     *
     * @param chosen   selects lights by their names
     * @param progress counts lights
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static void forEach(PixelCache cache, RenderOptions options, Predicate<String> chosen, Progress progress, Receiver receiver) {
        Scene scene = cache.scene();
        List<String> names = names(scene).stream().filter(chosen).toList();
        try (Renderer renderer = new Renderer(options)) {
            for (int l = 0; l < names.size(); l++) {
                progress.report(l, names.size());
                renderer.restore(cache);
                boolean isLight = scene.light(names.get(l)).isPresent();
                receiver.receive(names.get(l), isLight ? renderer.lightImage(names.get(l), progress.cancellationOnly())
                        : loss(cache.film(), LightShares.withoutEnvironment(renderer, cache, progress.cancellationOnly())));
            }
        }
        progress.report(names.size(), names.size());
    }

    private static Film loss(Film whole, Film without) {
        float[] rgb = whole.toScanlines();
        float[] rest = without.toScanlines();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = Math.max(0, rgb[i] - rest[i]);
        }
        return Film.ofScanlines(whole.width(), whole.height(), rgb);
    }
}
