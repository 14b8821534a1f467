package lightning.editor.window.command;

import javafx.scene.input.KeyEvent;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;

/** Keyboard shortcuts for the selected shape or group, in the list of shapes and in the preview. */
public final class ShapeKeys {
    private ShapeKeys() {}

    /** Runs the command of a key. Returns false if the key has none or no shape is selected. */
    public static boolean handle(CommandRegistry commands, KeyEvent event) {
        Command command = switch (event.getCode()) {
            case DELETE, BACK_SPACE -> Command.DELETE_SHAPE;
            case H, SPACE -> event.isShortcutDown() ? null : Command.SHOW_SHAPE;
            case D -> event.isShortcutDown() && !event.isShiftDown() ? Command.DUPLICATE_SHAPE : null;
            default -> null;
        };
        if (command == null || commands.editorState().get().selectedNode().isEmpty()) {
            return false;
        }
        commands.run(command);
        return true;
    }
}
