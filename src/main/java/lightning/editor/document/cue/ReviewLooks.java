package lightning.editor.document.cue;

import java.util.ArrayList;
import java.util.List;
import lightning.editor.document.EditOutcome;
import lightning.format.review.ReviewLook;
import lightning.scene.Scene;

/**
 * Looks of a scene for a review page.
 *
 * @param looks    looks that fit the scene
 * @param problems a sentence for each other one
 */
public record ReviewLooks(List<ReviewLook> looks, List<String> problems) {
    /**
     * Applies looks to a scene.
     *
     * @param cues  stored looks
     * @param scene scene of a picture
     */
    public static ReviewLooks of(List<Cue> cues, Scene scene) {
        List<ReviewLook> looks = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (Cue cue : cues) {
            if (cue.lighting().isEmpty()) {
                problems.add(cue.problem());
                continue;
            }
            switch (cue.lighting().get().applyTo(scene)) {
                case EditOutcome.Applied applied -> looks.add(new ReviewLook(cue.name(), applied.scene()));
                case EditOutcome.Refused refused -> problems.add(cue.name() + ": " + refused.reason());
            }
        }
        return new ReviewLooks(List.copyOf(looks), List.copyOf(problems));
    }
}
