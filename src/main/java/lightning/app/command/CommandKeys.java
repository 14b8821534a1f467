package lightning.app.command;

import java.util.stream.Stream;
import javafx.scene.Scene;
import lightning.app.model.EditorModel;
import lightning.edit.Command;

/** The commands' keys in a window that has no menu bar: all that no text and no control there takes for itself. */
public final class CommandKeys {
    private CommandKeys() {}

    /** Hears them, undo's before any part of the window does. */
    public static void take(Scene window, EditorModel model) {
        UndoKeys.take(window, model);
        model.keys().changesProperty().subscribe(_ -> {
            window.getAccelerators().clear();
            Stream.of(Command.values()).filter(model::isDone).forEach(command -> model.keys().of(command)
                    .ifPresent(key -> window.getAccelerators().put(key, () -> model.run(command))));
        });
    }
}
