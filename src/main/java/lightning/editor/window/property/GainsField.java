package lightning.editor.window.property;

import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.layout.StackPane;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ValueWidget;
import lightning.scene.value.ShapeGains;

/** Button that shows a light's gains on objects, if any, and opens the window that edits them. */
final class GainsField extends StackPane implements ValueWidget<ShapeGains> {
    private final Button button = new Button();
    private final DisabledReason disabledReason;

    /**
     * @param title  for screen readers
     * @param help  tooltip text
     */
    GainsField(CommandRegistry commands, String id, String title, String help) {
        button.setId(id);
        button.setAccessibleText(title);
        button.setMaxWidth(Double.MAX_VALUE);
        button.setMnemonicParsing(false);
        button.setOnAction(_ -> commands.run(Command.LIGHT_LINKS));
        getChildren().add(button);
        disabledReason = new DisabledReason(this, button, help);
    }

    @Override
    public void show(ShapeGains gains) {
        button.setText(gains.isNone() ? Command.LIGHT_LINKS.title() : gains.format());
    }

    @Override
    public void showNothing() {
        show(ShapeGains.NONE);
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }
}
