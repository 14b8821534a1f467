package lightning.editor.window.command;

import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyEvent;
import lightning.editor.document.Command;
import lightning.editor.window.model.CommandRegistry;

/** The commands' keys: in a window that has no menu bar all that no text and no control there takes for itself. */
public final class CommandKeys {
    private CommandKeys() {}

    /** Below a menu bar, which hears the keys of commands that are enabled: says of all others why they are not. */
    public static void explainDisabled(Node window, CommandRegistry commands) {
        window.addEventHandler(KeyEvent.KEY_PRESSED, e -> Stream.of(Command.values())
                .filter(command -> commands.hasAction(command) && commands.keyBindings().matches(command, e)
                        && !commands.isEnabled(command))
                .forEach(commands::runOrExplain));
    }

    /** Hears them, undo's before any part of the window does. */
    public static void install(Scene window, CommandRegistry commands) {
        UndoKeys.install(window, commands);
        commands.keyBindings().changesProperty().subscribe(_ -> {
            window.getAccelerators().clear();
            Stream.of(Command.values()).filter(commands::hasAction).forEach(command -> commands.keyBindings().binding(command)
                    .ifPresent(key -> window.getAccelerators().put(key, () -> commands.runOrExplain(command))));
        });
    }
}
