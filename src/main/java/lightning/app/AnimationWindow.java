package lightning.app;

import javafx.stage.Stage;
import javafx.stage.Window;

/** Records and plays the way of a light (paper §3.7). */
public final class AnimationWindow extends Stage {
    public AnimationWindow(EditorModel model, Window owner) {
        initOwner(owner);
        setTitle("Animation");
    }
}
