package lightning.editor.document;

import java.util.Optional;
import lightning.scene.Scene;
import lightning.scene.VisibleState;

/**
 * The edit that an artist has just made, to be judged.
 *
 * @param before  the scene that it started from
 * @param after   the scene that it led to, which gives a picture of the same size
 * @param isPending whether it is not rendered yet
 */
public record LastEdit(Scene before, Scene after, boolean isPending) {

    /**
     * What is not rendered yet; where nothing is, what the last update showed.
     *
     * @param scene    the document's scene
     * @param rendered what the picture shows
     * @param previous what it showed before
     */
    static Optional<LastEdit> of(Scene scene, Optional<Scene> rendered, Optional<Scene> previous) {
        boolean isPending = rendered.isPresent() && !VisibleState.isSame(rendered.get(), scene);
        Optional<Scene> before = isPending ? rendered : previous;
        Optional<Scene> after = isPending ? Optional.of(scene) : rendered;
        return before.isPresent() && after.isPresent() && before.get().hasSameShapes(after.get())
                ? Optional.of(new LastEdit(before.get(), after.get(), isPending)) : Optional.empty();
    }
}
