package lightning.editor.window.command;

import javafx.event.EventTarget;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.editor.document.Command;
import lightning.editor.window.model.Commands;

/**
 * The keys of undo and redo wherever the keyboard is. A text has an undo of its own, which would swallow the keys: it
 * comes first as long as something is typed there that is not set yet, and the document's when nothing is.
 */
public final class UndoKeys {
    private static final KeyCombination REDO_TOO = KeyCombination.valueOf("Shortcut+Y");

    private UndoKeys() {}

    /** Takes the keys before any part of a window does. */
    public static void take(EventTarget window, Commands commands) {
        window.addEventFilter(KeyEvent.KEY_PRESSED, e -> {
            if (commands.keys().is(Command.UNDO, e)) {
                undo(e, commands);
                e.consume();
            } else if (commands.keys().is(Command.REDO, e) || REDO_TOO.match(e) && commands.keys().owner(REDO_TOO).isEmpty()) {
                redo(e, commands);
                e.consume();
            }
        });
    }

    private static void undo(KeyEvent e, Commands commands) {
        if (e.getTarget() instanceof TextInputControl text && text.isUndoable()) {
            text.undo();
        } else {
            commands.press(Command.UNDO);
        }
    }

    private static void redo(KeyEvent e, Commands commands) {
        if (e.getTarget() instanceof TextInputControl text && text.isRedoable()) {
            text.redo();
        } else {
            commands.press(Command.REDO);
        }
    }
}
