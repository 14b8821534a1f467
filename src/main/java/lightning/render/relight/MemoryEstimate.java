package lightning.render.relight;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToLongFunction;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.gather.RowWeights;
import lightning.render.image.Film;
import lightning.render.relight.tile.FilmMemory;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.SampleCells;
import lightning.render.trace.TexelColumns;
import lightning.scene.AntialiasMode;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.value.SceneLimits;

/**
 * Memory estimate of a picture before any work begins. The upper bound follows the formula of docs/architecture.md, in which every
 * ray hits and every light reaches everything. If that is too much, a {@link MemoryForecast} measures small pictures.
 */
public final class MemoryEstimate {
    /** Bytes of a color in a film or a row. */
    static final long BYTES_PER_COLOR = 3L * Float.BYTES;
    /** Factor by which a suggested size shrinks until it fits. Edge samples shrink more slowly than pixels. */
    private static final double SHRINK_STEP = 0.9;

    private MemoryEstimate() {}

    /**
     * Returns the maximum bytes of rows, layers, samples and film of a first pass.
     *
     * @param scene scene as the view shows it
     */
    public static long upperBound(Scene scene, RenderOptions options) {
        return upperBound(scene, options, PictureParts.ALL);
    }

    static long upperBound(Scene scene, RenderOptions options, PictureParts parts) {
        PictureSettings picture = scene.picture();
        SamplingSettings sampling = picture.sampling();
        boolean mirrors = picture.depth() > 0 && scene.materials().stream().anyMatch(Material::spawnsSecondaryRays);
        boolean clear = mirrors && scene.materials().stream().anyMatch(Material::isClear);
        boolean tinted = scene.materials().stream().anyMatch(m -> m.transmission().tintsShadows());
        boolean glows = scene.materials().stream().anyMatch(m -> !m.glow().isBlack());
        boolean metallic = scene.materials().stream().anyMatch(Material::isMetallic);
        long lights =
                scene.rig().effectiveLights().stream().mapToLong(light -> options.method().bytesPerRow(light, metallic, tinted)).sum();
        int texelBytes = TexelColumns.ofAny(scene.stage().rendered().materials()).bytesPerRow();
        long row = ColumnGroup.HIT.bytesPerRow() + texelBytes
                + (sampling.isSupersampled() ? ColumnGroup.PATTERN.bytesPerRow() : 0)
                + (scene.lights().stream().allMatch(l -> l.illuminates().isAll() && l.influence().gains().isNone()) ? 0
                        : ColumnGroup.OWNER.bytesPerRow())
                + (clear ? ColumnGroup.TRANSPARENT.bytesPerRow() : 0) + lights
                + (GatherSettings.of(scene).isPresent() ? RowWeights.MAX_BYTES_PER_ROW : 0);
        // A clear surface sends two rays, and each of these may send two again.
        long levels = clear ? (2L << picture.depth()) - 2 : mirrors ? picture.depth() : 0;
        long mirrored =
                mirrors ? (clear ? 2 : 1) * BYTES_PER_COLOR + levels * (options.storesMirrorRows() ? row : Integer.BYTES) : 0;
        long samples = switch (sampling.antialias()) {
            case OFF -> 1;
            case EDGES -> parts == PictureParts.CENTERS ? 1 : 1L + sampling.samplesPerPixel();
            case EVERY -> sampling.samplesPerPixel();
        };
        // Samples store their colors if errors are bounded.
        long colored = !options.method().isExact() ? samples : sampling.antialias() == AntialiasMode.EVERY ? 0 : 1;
        return IndirectEstimate.upperBound(scene, levels, texelBytes, lights, glows) + PictureFog.maxBytes(scene)
                + FilmMemory.maxBytes(scene, parts == PictureParts.CENTERS) + pixels(picture)
                        * (samples * (row + mirrored + PictureFog.maxBytesPerRay(scene)) + colored * BYTES_PER_COLOR
                                + edgeColorBytes(sampling)
                                + (sampling.isSupersampled() ? 3 * BYTES_PER_COLOR : 0));
    }

    /** Returns the bytes of a cached picture: columns, colors and film. */
    public static long usedBytes(PixelCache cache) {
        PictureSettings picture = cache.scene().picture();
        return cache.bytes() + cache.colorBytes() + (picture.sampling().isSupersampled() ? BYTES_PER_COLOR * pixels(picture) : 0);
    }

    /**
     * Returns the approximate bytes of a first pass, measured with small pictures in a fraction of a second.
     *
     * @param scene scene as the view shows it
     */
    public static long forecast(Scene scene, RenderOptions options) {
        return MemoryForecast.of(scene, options).bytes(scene.picture());
    }

    /** Returns the pixels of whole tiles. */
    private static long pixels(PictureSettings picture) {
        return padded(picture.width()) * padded(picture.height());
    }

    private static long padded(int side) {
        return (side + Film.TILE_SIZE - 1L) / Film.TILE_SIZE * Film.TILE_SIZE;
    }

    /** Returns the bytes of the film and of the colors by which a trace detects edges. */
    static long filmBytes(PictureSettings picture) {
        return pixels(picture) * (BYTES_PER_COLOR + edgeColorBytes(picture.sampling()));
    }

    /** Returns the bytes of the colors of a pixel's center and of its first samples by which edges are detected. */
    private static long edgeColorBytes(SamplingSettings sampling) {
        return sampling.antialias() == AntialiasMode.EDGES ? (1L + SampleCells.first(sampling.grid()).count()) * Integer.BYTES : 0;
    }

    /**
     * Rejects a picture that does not fit.
     *
     * @param scene scene as the view shows it
     * @throws PictureTooLargeException if its first pass needs more than {@link RenderOptions#memory} minus the scene's meshes and
     *         their trees; the message suggests what would fit
     */
    public static void check(Scene scene, RenderOptions options) {
        new MemoryCheck().requirePicture(scene, options, PictureParts.ALL, SmallPictures.UNSEEN);
    }

    /**
     * Returns the changes of a picture that would fit.
     *
     * @param forecast forecast of the scene
     * @param required bytes that do not fit
     * @param memory   available bytes
     */
    static List<PictureTooLargeException.Suggestion> suggestions(Scene scene, MemoryForecast forecast, long required, long memory) {
        List<PictureTooLargeException.Suggestion> suggestions = new ArrayList<>();
        suggestSize(scene.picture(), forecast::bytes, required, memory, suggestions);
        if (forecast.parts() == PictureParts.ALL) {
            suggestSamples(scene.picture(), forecast, memory, suggestions);
        }
        return suggestions;
    }

    /**
     * Rejects a picture whose film alone does not fit.
     *
     * @param memory available bytes
     * @throws PictureTooLargeException if the film needs more
     */
    public static void checkFilm(PictureSettings picture, long memory) {
        long required = filmBytes(picture);
        if (required > memory) {
            double shrink = Math.sqrt((double) Math.max(memory, 0) / required);
            // Whole tiles, as in the estimate.
            int width = (int) (picture.width() * shrink) / Film.TILE_SIZE * Film.TILE_SIZE;
            int height = (int) (picture.height() * shrink) / Film.TILE_SIZE * Film.TILE_SIZE;
            throw new PictureTooLargeException(required, memory, 0,
                    Math.min(width, height) < 1 ? List.of() : List.of(new PictureTooLargeException.Suggestion.Size(width, height)));
        }
    }

    /** Adds the largest size that would fit, in steps. */
    static void suggestSize(PictureSettings picture, ToLongFunction<PictureSettings> bytes, long required, long available,
            List<PictureTooLargeException.Suggestion> suggestions) {
        for (double shrink = Math.sqrt((double) Math.max(available, 0) / required);
                shrink * Math.min(picture.width(), picture.height()) >= 1;
                shrink *= SHRINK_STEP) {
            PictureSettings smaller = picture.withSize((int) (picture.width() * shrink), (int) (picture.height() * shrink));
            if (bytes.applyAsLong(smaller) <= available) {
                suggestions.add(new PictureTooLargeException.Suggestion.Size(smaller.width(), smaller.height()));
                return;
            }
        }
    }

    private static void suggestSamples(PictureSettings picture, MemoryForecast forecast, long available,
            List<PictureTooLargeException.Suggestion> suggestions) {
        if (!picture.sampling().isSupersampled()) {
            return;
        }
        for (int grid = picture.sampling().grid() - 1; grid >= SceneLimits.MIN_SAMPLES; grid--) {
            if (forecast.bytes(picture.withSampling(new SamplingSettings(picture.sampling().antialias(), grid))) <= available) {
                suggestions.add(new PictureTooLargeException.Suggestion.Samples(grid));
                return;
            }
        }
        if (forecast.bytes(picture.withSampling(SamplingSettings.DEFAULT)) <= available) {
            suggestions.add(new PictureTooLargeException.Suggestion.NoAntialias());
        }
    }
}
