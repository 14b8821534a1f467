package lightning.bench.result;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Results of one scene at one size.
 *
 * @param scene     scene name: its file name without extension
 * @param width     pixels
 * @param height    pixels
 * @param depth     maximum reflection depth
 * @param before    file of the image before all edits, relative to the results; null if not written
 * @param firstPass cost of building the cache; null if not measured
 * @param edits     results in the paper's order
 * @param effects   cost of each used effect and saving of each absent one; empty if not measured
 * @param peer      trace by another program; null if none
 * @param cold      cold-start processes; null if not measured
 */
public record SceneResult(String scene, int width, int height, int depth, int shapes, int lights, @Nullable String before,
        @Nullable FirstPassResult firstPass, List<EditResult> edits, List<EffectResult> effects, @Nullable PeerResult peer,
        @Nullable ColdStart cold) {
    public SceneResult {
        edits = List.copyOf(edits);
        effects = List.copyOf(effects);
    }
}
