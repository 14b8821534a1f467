package lightning.review;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.SceneElement;

/**
 * What a reviewer changed in a page, and wrote.
 *
 * @param scene    title of the page
 * @param reviewer name of the reviewer; may be empty
 * @param exposure change of the exposure, stops
 * @param lights   changed lights
 * @param groups   changed light groups
 */
public record Review(String scene, String reviewer, double exposure, List<LightChange> lights, List<GroupChange> groups, List<Note> notes) {
    /**
     * Changed light or environment.
     *
     * @param areTogether true if the page has one fader for all environments, as those of earlier versions
     * @param stops     change from the light of the page; empty if its fader is off
     * @param tint      factors of red, green and blue, ≥ 0; {@code List} of three
     * @param intensity intensity when the page was written, ≥ 0
     * @param color     color when the page was written; empty for an environment
     */
    public record LightChange(Contribution light, boolean areTogether, Optional<Double> stops, List<Double> tint, double intensity,
            List<Double> color, boolean mute, boolean solo) {
        /** Returns what changes in a scene; empty if the scene does not have it. */
        List<Contribution> in(Scene scene) {
            // The first pages gave the environment a name only.
            boolean isEnvironment = light.equals(Contribution.ENVIRONMENT)
                    || light.equals(new SceneElement.OfLight("environment")) && !light.isIn(scene);
            return areTogether && isEnvironment ? Contribution.environments(scene) : light.isIn(scene) ? List.of(light) : List.of();
        }
    }

    /**
     * Changed light group.
     *
     * @param stops change from the group of the page; empty if its fader is off
     */
    public record GroupChange(String name, Optional<Double> stops, boolean mute, boolean solo) {}

    /**
     * Note at a place of a picture.
     *
     * @param frame number of the picture's frame; empty for a still picture
     * @param x share of the width, 0 to 1 from the left
     * @param y share of the height, 0 to 1 from the top
     */
    public record Note(OptionalInt frame, double x, double y, String text) {
        /** Creates a note of a still picture. */
        public Note(double x, double y, String text) {
            this(OptionalInt.empty(), x, y, text);
        }
    }
}
