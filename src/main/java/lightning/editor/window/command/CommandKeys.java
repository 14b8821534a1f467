package lightning.editor.window.command;

import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyEvent;
import lightning.editor.document.Command;
import lightning.editor.window.model.EditorModel;

/** The commands' keys: in a window that has no menu bar all that no text and no control there takes for itself. */
public final class CommandKeys {
    private CommandKeys() {}

    /** Below a menu bar, which hears the keys of commands that are enabled: says of all others why they are not. */
    public static void explain(Node window, EditorModel model) {
        window.addEventHandler(KeyEvent.KEY_PRESSED, e -> Stream.of(Command.values())
                .filter(command -> model.commands().isDone(command) && model.keys().is(command, e) && !model.commands().isEnabled(command))
                .forEach(model.commands()::press));
    }

    /** Hears them, undo's before any part of the window does. */
    public static void take(Scene window, EditorModel model) {
        UndoKeys.take(window, model);
        model.keys().changesProperty().subscribe(_ -> {
            window.getAccelerators().clear();
            Stream.of(Command.values()).filter(model.commands()::isDone).forEach(command -> model.keys().of(command)
                    .ifPresent(key -> window.getAccelerators().put(key, () -> model.commands().press(command))));
        });
    }
}
