package lightning.render.relight;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.gather.ray.PathsTooLargeException;
import lightning.render.trace.MeshMemory;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Check of a renderer's pictures against its memory limit. Stores the last forecast, because an editor checks a picture alone, then
 * next to the previous one, and once more when its first pass starts.
 */
final class MemoryCheck {
    private @Nullable MemoryForecast lastForecast;

    /**
     * Rejects a picture that does not fit.
     *
     * @param scene   scene as the view shows it
     * @param options options with the memory that is free for the picture and the scene's meshes
     * @throws PictureTooLargeException if it needs more; the message suggests what would fit
     * @throws CancellationException if the pictures' cancellation requested it
     */
    void requirePicture(Scene scene, RenderOptions options, PictureParts parts, SmallPictures pictures) {
        long memory = options.memory() - MeshMemory.bytes(scene);
        long max = MemoryEstimate.upperBound(scene, options, parts);
        if (max <= memory) {
            return;
        }
        if (memory <= 0) {
            throw new PictureTooLargeException(max, memory, 0, List.of());
        }
        try {
            updateForecast(scene, options.withMemory(memory), parts, pictures);
        } catch (PathsTooLargeException e) {
            throw tooLarge(scene, options.withMemory(memory), parts, e.requiredBytes(), pictures);
        }
        assert lastForecast != null;
        long required = lastForecast.bytes(scene.picture());
        if (required > memory) {
            List<PictureTooLargeException.Suggestion> suggestions =
                    new ArrayList<>(MemoryEstimate.suggestions(scene, lastForecast, required, memory));
            RenderOptions shapes = options.withSmallestMirrors();
            // Only callers that render all parts in one step offer the storage.
            if (parts == PictureParts.ALL && options.storesMirrorRows()
                    && MemoryForecast.of(scene, shapes, parts, pictures).bytes(scene.picture()) <= memory) {
                suggestions.add(new PictureTooLargeException.Suggestion.MirrorsAsShapes());
            }
            suggestions.addAll(SparserPaths.suggest(scene, options, parts, memory, pictures));
            throw new PictureTooLargeException(required, memory, lastForecast.indirectBytes(scene.picture()), suggestions);
        }
    }

    /** Returns the error for a scene of which not even the paths of a small picture fit: {@code paths} bytes, or more. */
    private PictureTooLargeException tooLarge(Scene scene, RenderOptions options, PictureParts parts, long paths, SmallPictures pictures) {
        long memory = options.memory();
        List<PictureTooLargeException.Suggestion> suggestions = new ArrayList<>();
        long required = paths;
        long indirect = paths;
        if (lastForecast != null && lastForecast.isOf(scene, options, parts)) {
            required = Math.max(paths, lastForecast.bytes(scene.picture()));
            indirect = Math.max(paths, lastForecast.indirectBytes(scene.picture()));
            suggestions.addAll(MemoryEstimate.suggestions(scene, lastForecast, required, memory));
        }
        suggestions.addAll(SparserPaths.suggest(scene, options, parts, memory, pictures));
        return new PictureTooLargeException(required, memory, indirect, suggestions);
    }

    private void updateForecast(Scene scene, RenderOptions options, PictureParts parts, SmallPictures pictures) {
        if (lastForecast == null || !lastForecast.isOf(scene, options, parts)) {
            lastForecast = MemoryForecast.upperOf(scene, options, parts, pictures);
        }
        if (lastForecast.isUpper() && lastForecast.bytes(scene.picture()) > options.memory()) {
            lastForecast = MemoryForecast.of(scene, options, parts, pictures);
        }
    }

    /**
     * Rejects finer samples that do not fit next to their centers.
     *
     * @param scene   scene of the samples
     * @param centers cache with its centers
     * @param options options with the memory that is free for centers, samples and the scene's meshes
     * @throws PictureTooLargeException if they need more; the message suggests what would fit
     * @throws CancellationException if the pictures' cancellation requested it
     */
    void requireSamples(Scene scene, PixelCache centers, RenderOptions options, SmallPictures pictures) {
        long memory = options.memory() - MeshMemory.bytes(scene);
        long centerBytes = centers.centerBytes();
        if (maxBytes(scene.picture(), centerBytes) + centers.indirectBytes() <= memory) {
            return;
        }
        // The paths of the picture exist, so those of small pictures fit.
        RenderOptions known = options.withMemory(Long.MAX_VALUE);
        if (lastForecast == null || !lastForecast.servesSamples(scene, options)) {
            lastForecast = MemoryForecast.upperOf(scene, known, PictureParts.ALL, pictures);
        }
        if (lastForecast.isUpper() && lastForecast.bytes(scene.picture()) > memory) {
            lastForecast = MemoryForecast.ofSamples(scene, centerBytes, known, pictures);
        }
        long required = lastForecast.bytes(scene.picture());
        if (required > memory) {
            throw new PictureTooLargeException(required, memory, lastForecast.indirectBytes(scene.picture()),
                    MemoryEstimate.suggestions(scene, lastForecast, required, memory));
        }
    }

    /** Returns the bytes of a picture with finer samples in every pixel, each of which takes as much as its center. */
    private static long maxBytes(PictureSettings picture, long centerBytes) {
        return centerBytes * (1 + picture.sampling().samplesPerPixel())
                + MemoryEstimate.BYTES_PER_COLOR * picture.width() * picture.height();
    }
}
