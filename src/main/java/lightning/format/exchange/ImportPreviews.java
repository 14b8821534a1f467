package lightning.format.exchange;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.render.image.Film;
import lightning.scene.ViewSettings;

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
     * Preview of a choice.
     *
     * @param film     linear image before exposure
     * @param exposure exposure that the lights of the file need, whole stops; 0 if they need none
     */
    public record Preview(Film film, double exposure) {
        /** Median luminances that need no exposure. */
        private static final double MIN_MEDIAN = 1.0 / 64;
        private static final double MAX_MEDIAN = 2;
        /** Median luminance after exposure. */
        private static final double GRAY = 0.25;

        /** Exposes a picture whose median would be white or black; pixels without light do not count. */
        static Preview exposed(Film film) {
            float[] rgb = film.toScanlines();
            double[] luminances = IntStream.range(0, rgb.length / 3)
                    .mapToDouble(i -> new Rgb(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]).luminance()).filter(v -> v > 0).sorted()
                    .toArray();
            double median = luminances.length == 0 ? GRAY : luminances[luminances.length / 2];
            return new Preview(film, median >= MIN_MEDIAN && median <= MAX_MEDIAN ? 0
                    : Math.clamp(Math.rint(Math.log(GRAY / median) / Math.log(2)), -ViewSettings.MAX_EXPOSURE, ViewSettings.MAX_EXPOSURE));
        }
    }

    /**
     * Renders an image for each choice, without textures, since these are not read before the scene is written: the lights of the file in
     * each possible unit, if it has lights, the likely one first, then a studio and a sky.
     *
     * @param size longer side in pixels, at least 1
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static Map<Choice, Preview> render(ImportedScene imported, int size, WorkerPool workers, Progress progress) {
        boolean hasUnits = imported.units().isPresent();
        List<ImportLighting> others = Arrays.stream(ImportLighting.values())
                .filter(lighting -> lighting != ImportLighting.FILE || !hasUnits && imported.subject().hasLights()).toList();
        int ofUnits = hasUnits ? LightUnits.values().length : 0;
        int count = ofUnits + others.size();
        Map<Choice, Preview> previews = new LinkedHashMap<>();
        Map<LightUnits, Film> films =
                LightUnitPreviews.render(imported, size, workers, new ProgressPart(progress, 0, (double) ofUnits / count));
        films.keySet().stream().sorted(Comparator.comparing(units -> !imported.units().equals(Optional.of(units))))
                .forEach(units -> previews.put(new Choice(ImportLighting.FILE, Optional.of(units)),
                        Preview.exposed(requireNonNull(films.get(units)))));
        for (int i = 0; i < others.size(); i++) {
            var choice = new Choice(others.get(i), Optional.empty());
            Film film = LightUnitPreviews.render(choice.apply(imported).scene(), size, workers,
                    new ProgressPart(progress, 0, 1).section(ofUnits + i, count));
            previews.put(choice, others.get(i) == ImportLighting.FILE ? Preview.exposed(film) : new Preview(film, 0));
        }
        return previews;
    }
}
