package lightning.editor;

import java.util.Optional;
import lightning.scene.Scene;
import lightning.scene.VisibleState;

/**
 * Last edit by the artist, to be measured.
 *
 * @param before    scene before the edit
 * @param after     scene after the edit, with the same image size
 * @param isPending whether it is not rendered yet
 */
public record LastEdit(Scene before, Scene after, boolean isPending) {

    /**
     * Returns the pending edit, or if there is none, the last rendered update.
     *
     * @param scene    scene of the document
     * @param rendered scene of the image
     * @param previous scene of the image before
     */
    static Optional<LastEdit> of(Scene scene, Optional<Scene> rendered, Optional<Scene> previous) {
        boolean isPending = rendered.isPresent() && !VisibleState.isSame(rendered.get(), scene);
        Optional<Scene> before = isPending ? rendered : previous;
        Optional<Scene> after = isPending ? Optional.of(scene) : rendered;
        return before.isPresent() && after.isPresent() && before.get().hasSameShapes(after.get())
                ? Optional.of(new LastEdit(before.get(), after.get(), isPending)) : Optional.empty();
    }
}
