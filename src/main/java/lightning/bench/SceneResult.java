package lightning.bench;

import java.util.List;

/**
 * What was measured on one scene at one size.
 *
 * @param scene     the scene's name: its file's without the ending
 * @param width     pixels
 * @param height    pixels
 * @param depth     how many mirror bounces are followed
 * @param before    the file of the picture before all edits, relative to the results; null where none was written
 * @param firstPass what keeping the picture costs; null where it was not measured
 * @param edits     in the paper's order
 * @param effects   what each effect takes, and what the absence of others saves; empty where it was not measured
 * @param peer      the same trace by another program; null where there is none
 * @param cold      the picture by processes that have just begun; null where it was not measured
 */
public record SceneResult(String scene, int width, int height, int depth, int shapes, int lights, String before,
        FirstPassResult firstPass, List<EditResult> edits, List<EffectResult> effects, PeerResult peer, ColdStart cold) {
    public SceneResult {
        edits = List.copyOf(edits);
        effects = List.copyOf(effects);
    }
}
