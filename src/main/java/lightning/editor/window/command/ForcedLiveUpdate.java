package lightning.editor.window.command;

import java.util.concurrent.Executor;
import javafx.scene.Node;
import javafx.stage.Window;
import javafx.util.Subscription;
import lightning.editor.document.EditorState;
import lightning.editor.window.model.SceneEditor;

/** Edits that are in the traced picture as soon as that can be, with or without Live: those of the mixer and of cues. */
public final class ForcedLiveUpdate {
    private ForcedLiveUpdate() {}

    /** Renders the scene as edited, unless it is rendered already or there was no picture yet. */
    public static void render(SceneEditor editor) {
        EditorState state = editor.editorStateProperty().get();
        if (!editor.liveProperty().get() && state.frame().isPresent() && state.hasPendingEdits()) {
            editor.go();
        }
    }

    /**
     * Renders each edit that comes while a pane's window has the keyboard, undo's and redo's too.
     *
     * @param window runs tasks in turn on the window's thread
     */
    public static Subscription renderWhileFocused(Node pane, SceneEditor editor, Executor window) {
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
