package lightning.editor.window.command;

import javafx.event.EventTarget;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;

/**
 * Shortcuts of undo and redo for a whole window. A text field's own undo comes first while it has uncommitted input, then the document's.
 */
public final class UndoKeys {
    private static final KeyCombination ALTERNATIVE_REDO = KeyCombination.valueOf("Shortcut+Y");

    private UndoKeys() {}

    /** Installs the shortcuts so that they precede all controls of a window. */
    public static void install(EventTarget window, CommandRegistry commands) {
        window.addEventFilter(KeyEvent.KEY_PRESSED, e -> {
            if (commands.keyBindings().matches(Command.UNDO, e)) {
                undo(e, commands);
                e.consume();
            } else if (commands.keyBindings().matches(Command.REDO, e)
                    || ALTERNATIVE_REDO.match(e) && commands.keyBindings().owner(ALTERNATIVE_REDO).isEmpty()) {
                redo(e, commands);
                e.consume();
            }
        });
    }

    private static void undo(KeyEvent e, CommandRegistry commands) {
        if (e.getTarget() instanceof TextInputControl text && text.isUndoable()) {
            text.undo();
        } else {
            commands.runOrExplain(Command.UNDO);
        }
    }

    private static void redo(KeyEvent e, CommandRegistry commands) {
        if (e.getTarget() instanceof TextInputControl text && text.isRedoable()) {
            text.redo();
        } else {
            commands.runOrExplain(Command.REDO);
        }
    }
}
