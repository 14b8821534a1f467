package lightning.review;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import lightning.document.EditOutcome;
import lightning.document.look.Look;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

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
     * @param stored stored looks
     * @param scene  scene of a picture
     */
    public static ReviewLooks of(List<Look> stored, Scene scene) {
        List<ReviewLook> looks = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (Look look : stored) {
            if (look.lighting().isEmpty()) {
                problems.add(look.problem());
                continue;
            }
            switch (look.lighting().get().applyTo(scene)) {
                case EditOutcome.Applied applied -> looks.add(new ReviewLook(look.name(), applied.scene()));
                case EditOutcome.Refused refused -> problems.add(look.name() + ": " + refused.reason());
            }
        }
        return new ReviewLooks(List.copyOf(looks), List.copyOf(problems));
    }

    /**
     * Returns pictures of frames with the looks that fit them.
     *
     * @param base scene of the shot without keyframes applied
     * @throws IllegalArgumentException as {@link Shot#sceneAt}
     */
    public static List<ReviewPicture> film(List<Look> looks, Shot shot, Scene base, List<Integer> frames) {
        List<ReviewPicture> pictures = new ArrayList<>();
        for (int frame : frames) {
            Scene scene = shot.sceneAt(base, frame);
            pictures.add(new ReviewPicture(OptionalInt.of(frame), scene, of(looks, scene).looks));
        }
        return pictures;
    }
}
