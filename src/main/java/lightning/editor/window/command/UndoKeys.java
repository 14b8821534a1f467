package lightning.editor.window.command;

import javafx.event.EventTarget;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.editor.document.Command;
import lightning.editor.window.model.EditorModel;

/**
 * The keys of undo and redo wherever the keyboard is. A text has an undo of its own, which would swallow the keys: it
 * comes first as long as something is typed there that is not set yet, and the document's when nothing is.
 */
public final class UndoKeys {
    private static final KeyCombination REDO_TOO = KeyCombination.valueOf("Shortcut+Y");

    private UndoKeys() {}

    /** Takes the keys before any part of a window does. */
    public static void take(EventTarget window, EditorModel model) {
        window.addEventFilter(KeyEvent.KEY_PRESSED, e -> {
            if (model.keys().is(Command.UNDO, e)) {
                undo(e, model);
                e.consume();
            } else if (model.keys().is(Command.REDO, e) || REDO_TOO.match(e) && model.keys().owner(REDO_TOO).isEmpty()) {
                redo(e, model);
                e.consume();
            }
        });
    }

    private static void undo(KeyEvent e, EditorModel model) {
        if (e.getTarget() instanceof TextInputControl text && text.isUndoable()) {
            text.undo();
        } else {
            model.commands().press(Command.UNDO);
        }
    }

    private static void redo(KeyEvent e, EditorModel model) {
        if (e.getTarget() instanceof TextInputControl text && text.isRedoable()) {
            text.redo();
        } else {
            model.commands().press(Command.REDO);
        }
    }
}
