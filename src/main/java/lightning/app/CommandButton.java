package lightning.app;

import javafx.scene.control.Button;
import javafx.scene.layout.StackPane;
import lightning.app.widget.Obstacle;
import lightning.edit.Command;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;

/** A button that does a command, and is disabled with the command's reason. */
final class CommandButton extends StackPane {

    /**
     * A button without text.
     *
     * @param title what it does, for the tooltip and for screen readers
     */
    CommandButton(EditorModel model, Command command, Ikon icon, String title) {
        Button button = new Button(null, FontIcon.of(icon));
        button.getStyleClass().addAll("button-icon", "flat");
        button.setAccessibleText(title);
        button.setId(command.name().toLowerCase().replace('_', '-'));
        button.setOnAction(_ -> model.run(command));
        getChildren().add(button);
        var obstacle = new Obstacle(this, button, title);
        model.situationProperty().subscribe(_ -> obstacle.set(model.reason(command)));
    }
}
