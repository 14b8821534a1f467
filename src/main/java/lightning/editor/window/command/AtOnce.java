package lightning.editor.window.command;

import java.util.concurrent.Executor;
import javafx.scene.Node;
import javafx.stage.Window;
import javafx.util.Subscription;
import lightning.editor.document.Situation;
import lightning.editor.window.model.SceneEditor;

/** Edits that are in the traced picture as soon as that can be, with or without Live: those of the mixer and of cues. */
public final class AtOnce {
    private AtOnce() {}

    /** Renders the scene as edited, unless it is rendered already or there was no picture yet. */
    public static void render(SceneEditor editor) {
        Situation now = editor.situationProperty().get();
        if (!editor.liveProperty().get() && now.frame().isPresent() && now.isPending()) {
            editor.go();
        }
    }

    /**
     * Renders each edit that comes while a pane's window has the keyboard, undo's and redo's too.
     *
     * @param window runs tasks in turn on the window's thread
     */
    public static Subscription whileFocused(Node pane, SceneEditor editor, Executor window) {
        // Whether the picture lacks the edit is known only when all have heard of it.
        return editor.sceneProperty().subscribe((_, _) -> window.execute(() -> {
            if (isFocused(pane)) {
                render(editor);
            }
        }));
    }

    private static boolean isFocused(Node pane) {
        Window window = pane.getScene() == null ? null : pane.getScene().getWindow();
        return window != null && window.isFocused();
    }
}
