package lightning.editor.window.command;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Insets;
import javafx.scene.control.CheckBox;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.KeyLabel;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Creates the items of a menu from commands. All menu items of the editor come from here, so that each has its command's title, shortcut
 * and enablement.
 */
public final class CommandMenuItems {
    private final CommandRegistry commands;
    private final String prefix;
    private final boolean hasKeys;

    private CommandMenuItems(CommandRegistry commands, String prefix, boolean hasKeys) {
        this.commands = commands;
        this.prefix = prefix;
        this.hasKeys = hasKeys;
    }

    /** Returns a factory for the menu bar, whose items carry the shortcuts. Their ids begin with {@code menu-}. */
    public static CommandMenuItems forMenuBar(CommandRegistry commands) {
        return new CommandMenuItems(commands, "menu-", true);
    }

    /** Returns a factory for other menus, without shortcuts: a shortcut must be registered once only. */
    public static CommandMenuItems forMenu(CommandRegistry commands) {
        return forMenu(commands, "");
    }

    /** @param prefix  prefix of the items' ids */
    public static CommandMenuItems forMenu(CommandRegistry commands, String prefix) {
        return new CommandMenuItems(commands, prefix, false);
    }

    /** Returns the command of an item, or empty if this class did not create it. */
    public static Optional<Command> command(MenuItem item) {
        return item.getUserData() instanceof Command command ? Optional.of(command) : Optional.empty();
    }

    /** Creates an item that runs a command, with a check mark for toggle commands. */
    public MenuItem item(Command command) {
        Optional<ObservableValue<Boolean>> on = commands.toggleState(command);
        MenuItem item = on.isPresent() ? checkItem(on.get()) : new MenuItem();
        item.setUserData(command);
        // Titles may contain names with underscores.
        item.setMnemonicParsing(false);
        item.setId(prefix + command.id());
        item.setGraphic(new FontIcon(command.icon()));
        if (hasKeys) {
            commands.keyBindings().changesProperty()
                    .subscribe(_ -> item.setAccelerator(commands.keyBindings().binding(command).map(KeyLabel::new).orElse(null)));
        }
        commands.editorState().subscribe(state -> {
            item.setText(command.title(state));
            item.setDisable(!command.isEnabled(state));
        });
        item.setOnAction(_ -> {
            closeMenus(item);
            commands.run(command);
            updateMark(item, on);
        });
        return item;
    }

    /** Closes the item's menus, which would otherwise cover a dialog opened by the action. */
    private static void closeMenus(MenuItem item) {
        for (Menu parent = item.getParentMenu(); parent != null; parent = parent.getParentMenu()) {
            parent.hide();
        }
        if (item.getParentPopup() != null) {
            item.getParentPopup().hide();
        }
    }

    private static CheckMenuItem checkItem(ObservableValue<Boolean> on) {
        var item = new CheckMenuItem();
        on.subscribe(item::setSelected);
        return item;
    }

    /** Restores the check mark, which the click has toggled regardless of the command's result. */
    private static void updateMark(MenuItem item, Optional<ObservableValue<Boolean>> on) {
        if (item instanceof CheckMenuItem check && on.isPresent()) {
            check.setSelected(on.get().getValue());
        }
    }

    /**
     * Creates an item that runs an action with a value of the command, for example a recent scene. For menus that are refilled each time
     * they open.
     */
    public MenuItem value(Command command, String title, Runnable action) {
        return prepared(new MenuItem(title, new FontIcon(command.icon())), command, action);
    }

    private <I extends MenuItem> I prepared(I item, Command command, Runnable action) {
        item.setMnemonicParsing(false);
        setAction(item, command, action);
        item.setDisable(!commands.isEnabled(command));
        return item;
    }

    /** Creates an item as {@link #value} does, for a menu that is filled once. */
    public MenuItem updatingValue(Command command, String title, Runnable action) {
        MenuItem item = value(command, title, action);
        commands.editorState().subscribe(state -> item.setDisable(!command.isEnabled(state)));
        return item;
    }

    /** Creates an item as {@link #value} does, with a radio mark. */
    public MenuItem radioValue(Command command, String title, boolean isChosen, Runnable action) {
        RadioMenuItem item = prepared(new RadioMenuItem(title), command, action);
        item.setSelected(isChosen);
        return item;
    }

    /** Creates an item as {@link #value} does, with a check mark. */
    public MenuItem checkValue(Command command, String title, boolean isChecked, Runnable action) {
        CheckMenuItem item = prepared(new CheckMenuItem(title), command, action);
        item.setSelected(isChecked);
        return item;
    }

    /**
     * Creates a check box as {@link #value} does. The menu stays open, so that several boxes can be changed in turn.
     *
     * @param indent  left indent, pixels
     * @param onChange  receives the new state
     */
    public MenuItem checkBoxValue(Command command, String title, boolean isChecked, double indent, Consumer<Boolean> onChange) {
        var box = new CheckBox(title);
        box.setMnemonicParsing(false);
        box.setSelected(isChecked);
        box.setPadding(new Insets(0, 0, 0, indent));
        var item = new CustomMenuItem(box, false);
        item.setUserData(command);
        item.setDisable(!commands.isEnabled(command));
        box.setOnAction(_ -> {
            if (commands.isEnabled(command)) {
                onChange.accept(box.isSelected());
            }
        });
        return item;
    }

    /** Creates a disabled item for an empty list of values. */
    public static MenuItem placeholder(Command command, String title) {
        var item = new MenuItem(title);
        item.setUserData(command);
        item.setDisable(true);
        return item;
    }

    /**
     * Creates a radio item for one of several values.
     *
     * @param id  suffix of the item's id
     * @param chosen  true if this value is selected
     */
    public MenuItem choice(Command command, String id, String title, ObservableValue<Boolean> chosen, Runnable action) {
        var item = new RadioMenuItem(title);
        item.setId(prefix + id);
        setAction(item, command, () -> {
            action.run();
            item.setSelected(chosen.getValue());
        });
        chosen.subscribe(item::setSelected);
        commands.editorState().subscribe(state -> item.setDisable(!command.isEnabled(state)));
        return item;
    }

    private void setAction(MenuItem item, Command command, Runnable action) {
        item.setUserData(command);
        item.setOnAction(_ -> {
            closeMenus(item);
            if (commands.isEnabled(command)) {
                action.run();
            }
        });
    }

    /** Creates a submenu with the values of a command. */
    public Menu menu(Command command, MenuItem... values) {
        var menu = new Menu(command.title(), new FontIcon(command.icon()), values);
        menu.setId(prefix + command.id());
        return menu;
    }
}
