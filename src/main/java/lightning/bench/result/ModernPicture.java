package lightning.bench.result;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Results of a modern scene with one kind of anti-aliasing.
 *
 * @param width      pixels, of the first pass and the edits
 * @param height     pixels, as {@code width}
 * @param firstPass  cost of building the cache; null if not measured
 * @param edits      updates after one edit each; empty if not measured
 * @param coldWidth  pixels, of cold-start processes
 * @param coldHeight pixels, as {@code coldWidth}
 * @param cold       cold-start processes; null if not measured
 */
public record ModernPicture(ModernSampling sampling, int width, int height, @Nullable FirstPassResult firstPass, List<ModernEdit> edits,
        int coldWidth, int coldHeight, @Nullable ColdStart cold) {
    public ModernPicture {
        edits = List.copyOf(edits);
    }
}
