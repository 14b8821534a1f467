package lightning.review;

import java.util.List;
import java.util.OptionalInt;
import lightning.scene.Scene;

/**
 * Picture of a review page.
 *
 * @param frame number of its frame; empty for a still picture
 * @param looks looks of it; all pictures of a page have the same ones
 */
public record ReviewPicture(OptionalInt frame, Scene scene, List<ReviewLook> looks) {
    /** Returns a still picture without looks. */
    public static ReviewPicture of(Scene scene) {
        return new ReviewPicture(OptionalInt.empty(), scene, List.of());
    }

    int pixels() {
        return scene.picture().width() * scene.picture().height();
    }

    /** Returns the looks that faders cannot show: the page has their pictures. */
    List<ReviewLook> fixedLooks() {
        return looks.stream().filter(look -> LookFaders.of(scene, look.scene()).isEmpty()).toList();
    }
}
