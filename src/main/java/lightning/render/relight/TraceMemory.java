package lightning.render.relight;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToLongFunction;
import lightning.render.RenderOptions;
import lightning.render.gather.ray.PathsTooLargeException;
import lightning.render.trace.MeshMemory;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/** Memory check of a trace without a cache. It keeps the film and the paths of indirect light, but no rows. */
public final class TraceMemory {
    private TraceMemory() {}

    /**
     * Rejects a scene whose trace does not fit. Renders small pictures if it may not.
     *
     * @param memory bytes for the trace and the scene's meshes
     * @throws PictureTooLargeException if it needs more; the message suggests what would fit
     */
    public static void check(Scene scene, long memory) {
        MemoryEstimate.checkFilm(scene.picture(), memory);
        long available = memory - MeshMemory.bytes(scene);
        if (GatherSettings.of(scene).isEmpty() || MemoryEstimate.upperBound(scene, RenderOptions.DEFAULT) <= available) {
            return;
        }
        try {
            long required = bytes(scene.picture(), MemoryForecast.upperIndirectOf(scene));
            if (required > available) {
                check(scene, MemoryForecast.indirectOf(scene), available);
            }
        } catch (PathsTooLargeException e) {
            // Not even the paths of a small picture fit.
            throw new PictureTooLargeException(e.requiredBytes(), available, e.requiredBytes(), sparserPaths(scene, available));
        }
    }

    private static void check(Scene scene, IndirectEstimate estimate, long available) {
        ToLongFunction<PictureSettings> bytes = picture -> bytes(picture, estimate);
        long required = bytes.applyAsLong(scene.picture());
        if (required > available) {
            List<PictureTooLargeException.Suggestion> suggestions = new ArrayList<>();
            MemoryEstimate.suggestSize(scene.picture(), bytes, required, available, suggestions);
            suggestions.addAll(sparserPaths(scene, available));
            throw new PictureTooLargeException(required, available, required - MemoryEstimate.filmBytes(scene.picture()), suggestions);
        }
    }

    private static List<PictureTooLargeException.Suggestion> sparserPaths(Scene scene, long available) {
        return SparserPaths.suggest(scene, sparser -> bytes(sparser.picture(), MemoryForecast.upperIndirectOf(sparser)) <= available);
    }

    private static long bytes(PictureSettings picture, IndirectEstimate estimate) {
        return MemoryEstimate.filmBytes(picture) + (long) Math.max(estimate.buildBytes(picture), estimate.bytes(picture));
    }
}
