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
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SpokenKey;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Makes the items of one menu. No item of the editor comes from elsewhere, so that each has the words, the key and the
 * obstacle of its command.
 */
public final class CommandItems {
    private final Commands commands;
    private final String prefix;
    private final boolean keys;

    private CommandItems(Commands commands, String prefix, boolean keys) {
        this.commands = commands;
        this.prefix = prefix;
        this.keys = keys;
    }

    /** Of the menu bar, whose items hold the keys. Their ids begin with {@code menu-}. */
    public static CommandItems ofBar(Commands commands) {
        return new CommandItems(commands, "menu-", true);
    }

    /** Of another menu; a key is heard once only. */
    public static CommandItems of(Commands commands) {
        return of(commands, "");
    }

    /** @param prefix of the items' ids */
    public static CommandItems of(Commands commands, String prefix) {
        return new CommandItems(commands, prefix, false);
    }

    /** The command that an item was made of; empty for one that was made in another way. */
    public static Optional<Command> command(MenuItem item) {
        return item.getUserData() instanceof Command command ? Optional.of(command) : Optional.empty();
    }

    /** Does the command; it has a mark where the command switches something. */
    public MenuItem item(Command command) {
        Optional<ObservableValue<Boolean>> on = commands.switched(command);
        MenuItem item = on.isPresent() ? checked(on.get()) : new MenuItem();
        item.setUserData(command);
        // An underscore in the name of what it acts on is one.
        item.setMnemonicParsing(false);
        item.setId(prefix + command.id());
        item.setGraphic(new FontIcon(command.icon()));
        if (keys) {
            commands.keys().changesProperty()
                    .subscribe(_ -> item.setAccelerator(commands.keys().of(command).map(SpokenKey::new).orElse(null)));
        }
        commands.situation().subscribe(now -> {
            item.setText(command.title(now));
            item.setDisable(!command.isEnabled(now));
        });
        item.setOnAction(_ -> {
            close(item);
            commands.run(command);
            mark(item, on);
        });
        return item;
    }

    /** Closes its menus, which would else be open until the action ends, over a question that this asks. */
    private static void close(MenuItem item) {
        for (Menu above = item.getParentMenu(); above != null; above = above.getParentMenu()) {
            above.hide();
        }
        if (item.getParentPopup() != null) {
            item.getParentPopup().hide();
        }
    }

    private static CheckMenuItem checked(ObservableValue<Boolean> on) {
        var item = new CheckMenuItem();
        on.subscribe(item::setSelected);
        return item;
    }

    /** A click has switched the mark already, whatever came of the command. */
    private static void mark(MenuItem item, Optional<ObservableValue<Boolean>> on) {
        if (item instanceof CheckMenuItem check && on.isPresent()) {
            check.setSelected(on.get().getValue());
        }
    }

    /** Does the command with a value of its own: one of the scenes opened before, say. For a menu that is filled anew when it opens. */
    public MenuItem value(Command command, String title, Runnable action) {
        var item = new MenuItem(title, new FontIcon(command.icon()));
        item.setMnemonicParsing(false);
        value(item, command, action);
        item.setDisable(!commands.isEnabled(command));
        return item;
    }

    /** As {@link #value}, for a menu that is filled once. */
    public MenuItem lastingValue(Command command, String title, Runnable action) {
        MenuItem item = value(command, title, action);
        commands.situation().subscribe(now -> item.setDisable(!command.isEnabled(now)));
        return item;
    }

    /** As {@link #value}, with a mark where it is the chosen one of several. */
    public MenuItem mark(Command command, String title, boolean chosen, Runnable action) {
        var item = new RadioMenuItem(title);
        item.setMnemonicParsing(false);
        value(item, command, action);
        item.setSelected(chosen);
        item.setDisable(!commands.isEnabled(command));
        return item;
    }

    /**
     * As {@link #value}, a box to check in a menu that stays open, so that several can be checked one after the other.
     *
     * @param indent pixels before it
     * @param check  hears whether it is checked
     */
    public MenuItem box(Command command, String title, boolean checked, double indent, Consumer<Boolean> check) {
        var box = new CheckBox(title);
        box.setMnemonicParsing(false);
        box.setSelected(checked);
        box.setPadding(new Insets(0, 0, 0, indent));
        var item = new CustomMenuItem(box, false);
        item.setUserData(command);
        item.setDisable(!commands.isEnabled(command));
        box.setOnAction(_ -> {
            if (commands.isEnabled(command)) {
                check.accept(box.isSelected());
            }
        });
        return item;
    }

    /** Stands where there is no value. */
    public static MenuItem nothing(Command command, String title) {
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
        value(item, command, () -> {
            action.run();
            item.setSelected(chosen.getValue());
        });
        chosen.subscribe(item::setSelected);
        commands.situation().subscribe(now -> item.setDisable(!command.isEnabled(now)));
        return item;
    }

    private void value(MenuItem item, Command command, Runnable action) {
        item.setUserData(command);
        item.setOnAction(_ -> {
            close(item);
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
