package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;

/** List cell with a name that can be edited in place. The list is editable only while renaming. */
abstract class NamedCell<T> extends ListCell<T> {
    private final CommandRegistry commands;
    /** Label of the name. */
    final Label name = new Label();
    private final Command command;
    private final NameField field;

    /**
     * @param command  command that renames
     * @param rename  renames from the first to the second name; returns a refusal
     */
    NamedCell(CommandRegistry commands, Command command, BiFunction<String, String, Optional<String>> rename) {
        this.commands = commands;
        this.command = command;
        field = new NameField(name, rename, this::cancelEdit, this::endRename);
    }

    /** Returns the name of the item that can be renamed, or empty. */
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
