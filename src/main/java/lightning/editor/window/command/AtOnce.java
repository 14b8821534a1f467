package lightning.editor.window.command;

import javafx.scene.Node;
import javafx.stage.Window;
import javafx.util.Subscription;
import lightning.editor.window.model.EditorModel;

/** Edits that are in the traced picture as soon as that can be, with or without Live: those of the mixer and of cues. */
public final class AtOnce {
    private AtOnce() {}

    /** Renders the scene as edited, unless it is rendered already or there was no picture yet. */
    public static void render(EditorModel model) {
        if (!model.liveProperty().get() && model.frame() != null && model.situationProperty().get().isPending()) {
            model.go();
        }
    }

    /** Renders each edit that comes while a pane's window has the keyboard, undo's and redo's too. */
    public static Subscription whileFocused(Node pane, EditorModel model) {
        // Whether the picture lacks the edit is known only when all have heard of it.
        return model.sceneProperty().subscribe((_, _) -> model.window().execute(() -> {
            if (isFocused(pane)) {
                render(model);
            }
        }));
    }

    private static boolean isFocused(Node pane) {
        Window window = pane.getScene() == null ? null : pane.getScene().getWindow();
        return window != null && window.isFocused();
    }
}
