package lightning.format.exchange;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;

/** Preview renderer for the lighting of an imported scene. */
public final class ImportPreviews {
    private ImportPreviews() {}

    /**
     * Choice for an import.
     *
     * @param units unit of the file's light intensities; empty if the file defines it, or if its lights are not used
     */
    public record Choice(ImportLighting lighting, Optional<LightUnits> units) {
        /** Returns the scene with this choice. Takes a moment for large scenes. */
        public ImportedScene apply(ImportedScene imported) {
            return lighting.apply(units.map(imported::inUnits).orElse(imported)).withSmoothEdges();
        }
    }

    /**
     * Renders an image for each choice, without textures, since these are not read before the scene is written: the lights of the file in
     * each possible unit, if it has lights, then a studio and a sky.
     *
     * @param size longer side in pixels, at least 1
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static Map<Choice, Film> render(ImportedScene imported, int size, WorkerPool workers, Progress progress) {
        Map<Choice, Film> films = new LinkedHashMap<>();
        LightUnitPreviews.render(imported, size, workers, progress)
                .forEach((units, film) -> films.put(new Choice(ImportLighting.FILE, Optional.of(units)), film));
        for (ImportLighting lighting : ImportLighting.values()) {
            if (lighting != ImportLighting.FILE || films.isEmpty() && imported.subject().hasLights()) {
                var choice = new Choice(lighting, Optional.empty());
                films.put(choice, LightUnitPreviews.render(choice.apply(imported).scene(), size, workers, progress));
            }
        }
        return films;
    }
}
