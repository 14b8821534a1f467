package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import lightning.editor.document.Command;
import lightning.editor.window.model.CommandRegistry;

/** A line of a list that shows a name, which is renamed in its place; the list can be edited only meanwhile. */
abstract class NamedCell<T> extends ListCell<T> {
    private final CommandRegistry commands;
    /** What shows the name. */
    final Label name = new Label();
    private final Command command;
    private final NameField field;

    /**
     * @param command what renaming is
     * @param rename  gives what is called by the first name the second; tells why it refuses to
     */
    NamedCell(CommandRegistry commands, Command command, BiFunction<String, String, Optional<String>> rename) {
        this.commands = commands;
        this.command = command;
        field = new NameField(name, rename, this::cancelEdit, this::endRename);
    }

    /** What can be renamed here, by its name; empty where nothing is. */
    abstract Optional<String> renameTarget();

    @Override
    public void startEdit() {
        Optional<String> old = renameTarget();
        if (old.isEmpty() || !commands.isEnabled(command)) {
            return;
        }
        super.startEdit();
        if (isEditing()) {
            field.open(old.get());
        }
    }

    @Override
    public void cancelEdit() {
        super.cancelEdit();
        field.close();
        getListView().setEditable(false);
        getListView().requestFocus();
    }

    private void endRename() {
        if (isEditing()) {
            cancelEdit();
        }
    }
}
