package lightning.editor.window.command;

import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyEvent;
import lightning.editor.document.Command;
import lightning.editor.window.model.Commands;

/** The commands' keys: in a window that has no menu bar all that no text and no control there takes for itself. */
public final class CommandKeys {
    private CommandKeys() {}

    /** Below a menu bar, which hears the keys of commands that are enabled: says of all others why they are not. */
    public static void explain(Node window, Commands commands) {
        window.addEventHandler(KeyEvent.KEY_PRESSED, e -> Stream.of(Command.values())
                .filter(command -> commands.isDone(command) && commands.keys().is(command, e) && !commands.isEnabled(command))
                .forEach(commands::press));
    }

    /** Hears them, undo's before any part of the window does. */
    public static void take(Scene window, Commands commands) {
        UndoKeys.take(window, commands);
        commands.keys().changesProperty().subscribe(_ -> {
            window.getAccelerators().clear();
            Stream.of(Command.values()).filter(commands::isDone).forEach(command -> commands.keys().of(command)
                    .ifPresent(key -> window.getAccelerators().put(key, () -> commands.press(command))));
        });
    }
}
