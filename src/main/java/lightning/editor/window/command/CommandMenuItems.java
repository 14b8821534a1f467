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
import lightning.editor.document.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.KeyLabel;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Makes the items of one menu. No item of the editor comes from elsewhere, so that each has the words, the key and the
 * obstacle of its command.
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

    /** Of the menu bar, whose items hold the keys. Their ids begin with {@code menu-}. */
    public static CommandMenuItems forMenuBar(CommandRegistry commands) {
        return new CommandMenuItems(commands, "menu-", true);
    }

    /** Of another menu; a key is heard once only. */
    public static CommandMenuItems forMenu(CommandRegistry commands) {
        return forMenu(commands, "");
    }

    /** @param prefix of the items' ids */
    public static CommandMenuItems forMenu(CommandRegistry commands, String prefix) {
        return new CommandMenuItems(commands, prefix, false);
    }

    /** The command that an item was made of; empty for one that was made in another way. */
    public static Optional<Command> command(MenuItem item) {
        return item.getUserData() instanceof Command command ? Optional.of(command) : Optional.empty();
    }

    /** Does the command; it has a mark where the command switches something. */
    public MenuItem item(Command command) {
        Optional<ObservableValue<Boolean>> on = commands.toggleState(command);
        MenuItem item = on.isPresent() ? checkItem(on.get()) : new MenuItem();
        item.setUserData(command);
        // An underscore in the name of what it acts on is one.
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

    /** Closes its menus, which would else be open until the action ends, over a question that this asks. */
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

    /** A click has switched the mark already, whatever came of the command. */
    private static void updateMark(MenuItem item, Optional<ObservableValue<Boolean>> on) {
        if (item instanceof CheckMenuItem check && on.isPresent()) {
            check.setSelected(on.get().getValue());
        }
    }

    /** Does the command with a value of its own: one of the scenes opened before, say. For a menu that is filled anew when it opens. */
    public MenuItem value(Command command, String title, Runnable action) {
        var item = new MenuItem(title, new FontIcon(command.icon()));
        item.setMnemonicParsing(false);
        setAction(item, command, action);
        item.setDisable(!commands.isEnabled(command));
        return item;
    }

    /** As {@link #value}, for a menu that is filled once. */
    public MenuItem updatingValue(Command command, String title, Runnable action) {
        MenuItem item = value(command, title, action);
        commands.editorState().subscribe(state -> item.setDisable(!command.isEnabled(state)));
        return item;
    }

    /** As {@link #value}, with a mark where it is the chosen one of several. */
    public MenuItem radioValue(Command command, String title, boolean isChosen, Runnable action) {
        var item = new RadioMenuItem(title);
        item.setMnemonicParsing(false);
        setAction(item, command, action);
        item.setSelected(isChosen);
        item.setDisable(!commands.isEnabled(command));
        return item;
    }

    /**
     * As {@link #value}, a box to check in a menu that stays open, so that several can be checked one after the other.
     *
     * @param indent pixels before it
     * @param onChange  hears whether it is checked
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

    /** Stands where there is no value. */
    public static MenuItem placeholder(Command command, String title) {
        var item = new MenuItem(title);
        item.setUserData(command);
        item.setDisable(true);
        return item;
    }

    /**
     * One of several values of which one is chosen.
     *
     * @param id     follows the prefix
     * @param chosen whether it is this one
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

    /** The values of a command as a menu within a menu. */
    public Menu menu(Command command, MenuItem... values) {
        var menu = new Menu(command.title(), new FontIcon(command.icon()), values);
        menu.setId(prefix + command.id());
        return menu;
    }
}
