package lightning.app.command;

import java.util.Locale;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.StackPane;
import javafx.util.Duration;
import lightning.app.model.EditorModel;
import lightning.edit.Command;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * A button of a command, enabled exactly when there is something to do, with a tooltip that says why not. The tooltip
 * hangs on the frame around the button, for JavaFX shows none of a disabled control.
 */
public final class CommandButton extends StackPane {
    private static final Duration DELAY = Duration.millis(400);

    /** @param titled whether the title stands beside the icon */
    public CommandButton(EditorModel model, Command command, boolean titled) {
        this(model, command, titled, new Button());
    }

    private CommandButton(EditorModel model, Command command, boolean titled, ButtonBase button) {
        CommandFace face = CommandFace.of(command);
        button.setText(titled ? face.title() : "");
        button.setGraphic(new FontIcon(face.icon()));
        button.setId(id(command));
        button.setAccessibleText(face.title());
        button.setOnAction(_ -> model.run(command));
        button.getStyleClass().add(titled ? "titled-command" : "button-icon");
        getChildren().add(button);
        var tooltip = new Tooltip();
        tooltip.setShowDelay(DELAY);
        tooltip.setShowDuration(Duration.INDEFINITE);
        Tooltip.install(this, tooltip);
        model.situationProperty().subscribe(_ -> {
            String obstacle = model.reason(command).orElse("");
            button.setDisable(!obstacle.isEmpty());
            tooltip.setText(face.tooltip(obstacle));
            button.setAccessibleHelp(tooltip.getText());
        });
    }

    /** The eye of the selected light, which stays down while the preview looks through it. */
    public static CommandButton lookThrough(EditorModel model) {
        var eye = new ToggleButton();
        var button = new CommandButton(model, Command.LOOK_THROUGH_LIGHT, false, eye);
        var on = model.lookThrough().onProperty();
        on.subscribe(eye::setSelected);
        eye.setOnAction(_ -> {
            model.run(Command.LOOK_THROUGH_LIGHT);
            eye.setSelected(on.get());
        });
        return button;
    }

    public ButtonBase button() {
        return (ButtonBase) getChildren().getFirst();
    }

    /** {@code go} for {@code GO}, {@code save-scene} for {@code SAVE_SCENE}. */
    public static String id(Command command) {
        return command.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
