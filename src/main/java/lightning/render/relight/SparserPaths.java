package lightning.render.relight;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import lightning.render.RenderOptions;
import lightning.render.gather.ray.PathsTooLargeException;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Finds settings of indirect light whose paths fit into memory if those of a scene are denser than the defaults. */
final class SparserPaths {
    private SparserPaths() {}

    /**
     * Returns the first settings that fit, as a suggestion; none if the scene's settings are not dense, or nothing fits.
     *
     * @param memory available bytes
     */
    static List<PictureTooLargeException.Suggestion> suggest(Scene scene, RenderOptions options, PictureParts parts, long memory,
            SmallPictures pictures) {
        return suggest(scene, sparser -> MemoryForecast.upperOf(sparser, options, parts, pictures).bytes(sparser.picture()) <= memory);
    }

    /**
     * Returns the first settings that fit, as a suggestion.
     *
     * @param fits tests the scene with sparser settings; it may throw {@link PathsTooLargeException}
     */
    static List<PictureTooLargeException.Suggestion> suggest(Scene scene, Predicate<Scene> fits) {
        Optional<IndirectSettings> settings = scene.picture().indirect().map(SparserPaths::next);
        while (settings.isPresent()) {
            if (isFitting(scene.withPicture(scene.picture().withIndirect(settings)), fits)) {
                return List.of(new PictureTooLargeException.Suggestion.Paths(settings.get()));
            }
            settings = settings.map(SparserPaths::next);
        }
        return List.of();
    }

    /** Returns the next sparser settings; null after the defaults. */
    private static @Nullable IndirectSettings next(IndirectSettings settings) {
        IndirectSettings defaults = IndirectSettings.DEFAULT;
        return settings.rays() > defaults.rays() ? settings.withRays(settings.rays() / 4)
                : settings.bounces() > defaults.bounces() ? settings.withBounces(defaults.bounces())
                : settings.spacing() < defaults.spacing() ? settings.withSpacing(Math.min(2 * settings.spacing(), defaults.spacing()))
                : null;
    }

    private static boolean isFitting(Scene sparser, Predicate<Scene> fits) {
        try {
            return fits.test(sparser);
        } catch (PathsTooLargeException e) {
            return false;
        }
    }
}
