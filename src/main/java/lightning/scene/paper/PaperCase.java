package lightning.scene.paper;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;

/**
 * Named edit, or sequence of edits, of one scene.
 *
 * @param name        name in lower case, equal on every scene: {@code color}, {@code angle-smaller}, …
 * @param figure      figure of the paper, as in {@code Fig. 6}; empty if none
 * @param paperSaving saving in the paper on its own scene, 0…100 percent of a full trace's time; NaN if not printed
 * @param scenes      scenes rendered in sequence; at least two
 */
public record PaperCase(String name, String figure, double paperSaving, List<Scene> scenes) {

    /** @throws IllegalArgumentException if there are fewer than two scenes */
    public PaperCase {
        scenes = List.copyOf(scenes);
        if (scenes.size() < 2) {
            throw new IllegalArgumentException("case " + Quote.of(name) + ": expected at least two scenes, found " + scenes.size());
        }
    }

    /** Returns a case that is not in the paper, created from a scene by some steps. */
    public static PaperCase unprinted(String name, Scene before, Scene... steps) {
        return new PaperCase(name, "", Double.NaN, Stream.concat(Stream.of(before), Stream.of(steps)).toList());
    }

    /** Returns the initial scene, traced in full. */
    public Scene before() {
        return scenes.getFirst();
    }

    /** Returns the final scene, whose image the case measures. */
    public Scene after() {
        return scenes.getLast();
    }

    /** Returns the change of the last step, as in {@code sun: color 1 1 1 → 1 0 0}. */
    public String value() {
        return SceneDiff.describe(scenes.get(scenes.size() - 2), after());
    }

    /** Returns whether the paper prints this edit. */
    public boolean isPrinted() {
        return !figure.isEmpty();
    }
}
