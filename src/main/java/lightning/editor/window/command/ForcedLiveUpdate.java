package lightning.editor.window.command;

import java.util.concurrent.Executor;
import javafx.scene.Node;
import javafx.stage.Window;
import javafx.util.Subscription;
import lightning.editor.document.EditorState;
import lightning.editor.window.model.SceneEditor;

/** Renders edits of the mixer and of cues immediately, also while Live is off. */
public final class ForcedLiveUpdate {
    private ForcedLiveUpdate() {}

    /** Renders the scene as edited, unless it is already rendered or there is no picture yet. */
    public static void render(SceneEditor editor) {
        EditorState state = editor.editorStateProperty().get();
        if (!editor.liveProperty().get() && state.frame().isPresent() && state.hasPendingEdits()) {
            editor.go();
        }
    }

    /**
     * Renders every edit, including undo and redo, while the window of a pane has focus.
     *
     * @param window  runs tasks in order on the window's thread
     */
    public static Subscription renderWhileFocused(Node pane, SceneEditor editor, Executor window) {
        // Deferred: the pending state is known only after all listeners have run.
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
