package lightning.editor.window.command;

import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyEvent;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;

/** Keyboard shortcuts of the commands in a window. Text fields and controls handle their own keys first. */
public final class CommandKeys {
    private CommandKeys() {}

    /** Shows why a command is disabled when its shortcut is pressed. For windows with a menu bar, which handles enabled commands. */
    public static void explainDisabled(Node window, CommandRegistry commands) {
        window.addEventHandler(KeyEvent.KEY_PRESSED, e -> Stream.of(Command.values())
                .filter(command -> commands.hasAction(command) && commands.keyBindings().matches(command, e)
                        && !commands.isEnabled(command))
                .forEach(commands::runOrExplain));
    }

    /** Installs all shortcuts in a window without a menu bar. Undo and redo precede the keys of controls. */
    public static void install(Scene window, CommandRegistry commands) {
        UndoKeys.install(window, commands);
        commands.keyBindings().changesProperty().subscribe(_ -> {
            window.getAccelerators().clear();
            Stream.of(Command.values()).filter(commands::hasAction).forEach(command -> commands.keyBindings().binding(command)
                    .ifPresent(key -> window.getAccelerators().put(key, () -> commands.runOrExplain(command))));
        });
    }
}
