package lightning.editor.window.command;

import java.util.concurrent.Executor;
import javafx.scene.Node;
import javafx.stage.Window;
import javafx.util.Subscription;
import lightning.editor.EditorState;
import lightning.editor.window.model.SceneEditor;

/** Renders edits of the mixer and of looks immediately, also while Live is off. */
public final class ForcedLiveUpdate {
    private ForcedLiveUpdate() {}

    /**
     * Renders every edit, including undo and redo, while the window of a pane has focus.
     *
     * @param window  runs tasks in order on the window's thread
     */
    public static Subscription renderWhileFocused(Node pane, SceneEditor editor, Executor window) {
        // Deferred: the pending state is known only after all listeners have run.
        return editor.sceneProperty().subscribe((_, _) -> window.execute(() -> {
            EditorState state = editor.editorStateProperty().get();
            if (isFocused(pane) && !editor.liveProperty().get() && state.frame().isPresent() && state.hasPendingEdits()) {
                editor.go();
            }
        }));
    }

    private static boolean isFocused(Node pane) {
        Window window = pane.getScene() == null ? null : pane.getScene().getWindow();
        return window != null && window.isFocused();
    }
}
