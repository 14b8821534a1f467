package lightning.bench.accuracy;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;

/**
 * A named edit, or a sequence of edits, of one scene.
 *
 * @param name        lower case, the same on every scene: {@code color}, {@code angle-smaller}, …
 * @param figure      where the paper shows it, as in {@code Fig. 6}; empty where it does not
 * @param paperSaving percent of a full trace's time that the paper saved on its own scene, 0…100; NaN where it printed none
 * @param scenes      what is rendered, one after the other; at least two
 */
public record PaperCase(String name, String figure, double paperSaving, List<Scene> scenes) {

    /** @throws IllegalArgumentException if there are fewer than two scenes */
    public PaperCase {
        scenes = List.copyOf(scenes);
        if (scenes.size() < 2) {
            throw new IllegalArgumentException("case " + Quote.of(name) + ": expected at least two scenes, found " + scenes.size());
        }
    }

    /** A case that the paper does not have, from a scene by some steps. */
    static PaperCase unprinted(String name, Scene before, Scene... steps) {
        return new PaperCase(name, "", Double.NaN, Stream.concat(Stream.of(before), Stream.of(steps)).toList());
    }

    /** The scene that is traced in full at first. */
    public Scene before() {
        return scenes.getFirst();
    }

    /** The scene whose picture the case is about. */
    public Scene after() {
        return scenes.getLast();
    }

    /** What the last step changes to what, as in {@code sun: color 1 1 1 → 1 0 0}. */
    public String value() {
        return SceneDiff.describe(scenes.get(scenes.size() - 2), after());
    }

    /** Whether the paper prints this edit. */
    public boolean isPrinted() {
        return !figure.isEmpty();
    }
}
