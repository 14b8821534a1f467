package lightning.render.relight;

import java.util.List;
import java.util.Optional;
import lightning.render.gather.PathsTooLargeException;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;

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
        Optional<IndirectSettings> settings = scene.picture().indirect().map(SparserPaths::next);
        while (settings.isPresent()) {
            if (fits(scene.withPicture(scene.picture().withIndirect(settings)), options, parts, memory, pictures)) {
                return List.of(new PictureTooLargeException.Suggestion.Paths(settings.get()));
            }
            settings = settings.map(SparserPaths::next);
        }
        return List.of();
    }

    /** Returns the next sparser settings; null after the defaults. */
    private static IndirectSettings next(IndirectSettings settings) {
        IndirectSettings defaults = IndirectSettings.DEFAULT;
        return settings.rays() > defaults.rays() ? settings.withRays(settings.rays() / 4)
                : settings.bounces() > defaults.bounces() ? settings.withBounces(defaults.bounces())
                : settings.spacing() < defaults.spacing() ? settings.withSpacing(Math.min(2 * settings.spacing(), defaults.spacing()))
                : null;
    }

    private static boolean fits(Scene scene, RenderOptions options, PictureParts parts, long memory, SmallPictures pictures) {
        try {
            return MemoryForecast.upperOf(scene, options, parts, pictures).bytes(scene.picture()) <= memory;
        } catch (PathsTooLargeException e) {
            return false;
        }
    }
}
