package lightning.document.imports;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
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
import lightning.base.work.WorkerPool;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.PictureSettings;
import lightning.scene.ViewSettings;

/** Choices of the lighting of an imported scene, each with a preview. Thread-safe. */
public final class ImportPreviews {
    private final ImportedScene imported;
    private final int size;
    private final LightUnitPreviews unitPreviews;
    private final Map<Choice, Preview> ready = new LinkedHashMap<>();

    /** @param size longer side of the previews in pixels, at least 1 */
    public ImportPreviews(ImportedScene imported, int size) {
        this.imported = imported;
        this.size = size;
        unitPreviews = new LightUnitPreviews(imported, size);
    }

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
        /** Returns the displayed pixels. */
        public int[] pixels() {
            return ViewTransform.DEFAULT.withExposure(exposure).toPixels(film);
        }

        /** Returns whether all pixels are equal. */
        boolean isEmpty() {
            int[] pixels = pixels();
            return Arrays.stream(pixels).allMatch(pixel -> pixel == pixels[0]);
        }

        /** Median luminances that need no exposure. */
        private static final double MIN_MEDIAN = 1.0 / 64;
        private static final double MAX_MEDIAN = 2;
        /** Median luminance after exposure. */
        private static final double GRAY = 0.25;

        /** Exposes a picture whose median would be white or black; pixels without light do not count. */
        public static Preview exposed(Film film) {
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
     * Returns all choices in the order in which they are offered: a studio, which suits every file, then the lights of the file in each possible
     * unit, if it has lights, the likely one first, then the image of a studio and a sky.
     */
    public List<Choice> choices() {
        List<Choice> choices = new ArrayList<>(List.of(new Choice(ImportLighting.STUDIO, Optional.empty())));
        if (imported.units().isPresent()) {
            Arrays.stream(LightUnits.values()).sorted(Comparator.comparing(units -> !imported.units().equals(Optional.of(units))))
                    .forEach(units -> choices.add(new Choice(ImportLighting.FILE, Optional.of(units))));
        } else if (imported.subject().hasLights()) {
            choices.add(new Choice(ImportLighting.FILE, Optional.empty()));
        }
        for (ImportLighting lighting : List.of(ImportLighting.SOFTBOXES, ImportLighting.SKY)) {
            if (lighting.isAvailable()) {
                choices.add(new Choice(lighting, Optional.empty()));
            }
        }
        return choices;
    }

    /** Returns the size of a preview without its picture. */
    public PictureSettings picture() {
        return LightUnitPreviews.small(imported.unscaledScene().picture(), size);
    }

    /**
     * Renders the preview of a choice, without textures, since these are not read before the scene is written. Renders each only once; waits for
     * another thread that renders one.
     *
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public synchronized Preview render(Choice choice, WorkerPool workers, Progress progress) {
        Preview known = ready.get(choice);
        if (known != null) {
            return known;
        }
        Film film = choice.units().isPresent() ? unitPreviews.render(choice.units().get(), workers, progress)
                : LightUnitPreviews.render(choice.apply(imported).scene(), size, workers, progress);
        Preview preview = choice.lighting() == ImportLighting.FILE ? Preview.exposed(film) : new Preview(film, 0);
        ready.put(choice, preview);
        return preview;
    }

    /** Returns whether the preview of a choice shows something, and no other that was rendered before it looks the same. */
    public synchronized boolean isUseful(Choice choice) {
        Preview preview = requireNonNull(ready.get(choice), "the preview must be rendered before");
        return !preview.isEmpty() && ready.entrySet().stream().takeWhile(other -> !other.getKey().equals(choice))
                .noneMatch(other -> Arrays.equals(other.getValue().pixels(), preview.pixels()));
    }
}
