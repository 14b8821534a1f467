package lightning.editor.window.command;

import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.StackPane;
import javafx.util.Duration;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Button of a command. It is disabled, with the reason in its tooltip, while the command has nothing to do; a toggle command keeps it
 * pressed.
 *
 * <p>The tooltip belongs to the surrounding pane, since JavaFX shows none on a disabled control.
 */
public final class CommandButton extends StackPane {
    private static final Duration DELAY = Duration.millis(400);

    private final ButtonBase button;

    private CommandButton(CommandRegistry commands, Command command) {
        button = commands.toggleState(command).<ButtonBase>map(on -> toggle(on)).orElseGet(Button::new);
        button.setId(command.id());
        button.setAccessibleText(command.plainTitle());
        button.setOnAction(_ -> {
            commands.run(command);
            if (button instanceof ToggleButton toggle) {
                toggle.setSelected(commands.toggleState(command).orElseThrow().getValue());
            }
        });
        getChildren().add(button);
        var tooltip = new Tooltip();
        tooltip.setShowDelay(DELAY);
        tooltip.setShowDuration(Duration.INDEFINITE);
        Tooltip.install(this, tooltip);
        commands.editorState().map(command::disabledReason).subscribe(reason -> {
            button.setDisable(reason.isPresent());
            updateTooltip(tooltip, commands, command);
        });
        commands.keyBindings().changesProperty().subscribe(_ -> updateTooltip(tooltip, commands, command));
    }

    private void updateTooltip(Tooltip tooltip, CommandRegistry commands, Command command) {
        tooltip.setText(help(command, commands.keyBindings().text(command), commands.disabledReason(command).orElse("")));
        button.setAccessibleHelp(tooltip.getText());
    }

    private static ToggleButton toggle(ObservableValue<Boolean> on) {
        var button = new ToggleButton();
        on.subscribe(button::setSelected);
        return button;
    }

    /** Creates a button with the command's icon only. */
    public static CommandButton iconButton(CommandRegistry commands, Command command) {
        return new CommandButton(commands, command).withStyle("", new FontIcon(command.icon()), "button-icon");
    }

    /** Creates a button with icon and title. */
    public static CommandButton titledButton(CommandRegistry commands, Command command) {
        return new CommandButton(commands, command).withStyle(command.title(), new FontIcon(command.icon()), "titled-command");
    }

    /** Creates a button of the preview's view bar, with a short text in place of the title. */
    public static CommandButton viewButton(CommandRegistry commands, Command command, String text) {
        return new CommandButton(commands, command).withStyle(text, null, "view-button");
    }

    /** Creates a button of the preview's view bar, with an icon. */
    public static CommandButton viewButton(CommandRegistry commands, Command command) {
        return new CommandButton(commands, command).withStyle("", new FontIcon(command.icon()), "view-button");
    }

    private CommandButton withStyle(String text, @Nullable FontIcon icon, String styleClass) {
        button.setText(text);
        button.setGraphic(icon);
        button.getStyleClass().add(styleClass);
        return this;
    }

    public ButtonBase button() {
        return button;
    }

    /**
     * Returns the tooltip's text.
     *
     * @param key  shortcut of the command; empty for none
     * @param disabledReason  why the command is disabled; empty if it is enabled
     */
    static String help(Command command, String key, String disabledReason) {
        String description = command.plainTitle() + (key.isEmpty() ? "" : "  (" + key + ")") + "\n" + command.help() + ".";
        return disabledReason.isEmpty() ? description : Messages.tr("{0}\nUnavailable: {1}.", description, disabledReason);
    }
}
