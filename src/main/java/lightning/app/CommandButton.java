package lightning.app;

import java.util.Locale;
import javafx.scene.AccessibleRole;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.StackPane;
import javafx.util.Duration;
import lightning.edit.Command;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * A button of a command, enabled exactly when there is something to do, with a tooltip that says why not. The tooltip
 * hangs on the frame around the button, for JavaFX shows none of a disabled control.
 */
final class CommandButton extends StackPane {
    private static final Duration DELAY = Duration.millis(400);

    /** @param titled whether the title stands beside the icon */
    CommandButton(EditorModel model, Command command, boolean titled) {
        CommandFace face = CommandFace.of(command);
        var button = new Button(titled ? face.title() : "", new FontIcon(face.icon()));
        button.setId(id(command));
        button.setAccessibleRole(AccessibleRole.BUTTON);
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

    /** A button for the header of a pane. */
    static CommandButton small(EditorModel model, Command command) {
        var small = new CommandButton(model, command, false);
        small.button().getStyleClass().add("view-button");
        return small;
    }

    Button button() {
        return (Button) getChildren().getFirst();
    }

    /** {@code go} for {@code GO}, {@code save-scene} for {@code SAVE_SCENE}. */
    static String id(Command command) {
        return command.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
