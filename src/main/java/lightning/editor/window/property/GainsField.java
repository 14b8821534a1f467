package lightning.editor.window.property;

import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.EditorState;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.widget.DisabledReason;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.LightAttribute;
import lightning.scene.value.ShapeGains;

/** Button that shows the selected light's gains on objects, if any, and opens the window that edits them. */
final class GainsField extends StackPane {
    private final LightAttribute<ShapeGains> attribute;
    private final Button button = new Button();
    private final DisabledReason disabledReason;

    /** @param visibleState  state as in {@link PropertyPane} */
    GainsField(CommandRegistry commands, LightAttribute<ShapeGains> attribute, ValueKind.GainsKind kind,
            ObservableValue<EditorState> visibleState) {
        this.attribute = attribute;
        button.setId(attribute.name());
        button.setAccessibleText(Messages.tr(attribute.title()));
        button.setMaxWidth(Double.MAX_VALUE);
        button.setMnemonicParsing(false);
        button.setOnAction(_ -> commands.run(Command.LIGHT_LINKS));
        getChildren().add(button);
        disabledReason = new DisabledReason(this, button, Messages.tr(kind.help()));
        visibleState.subscribe(this::show);
    }

    private void show(EditorState state) {
        button.setText(state.selectedLight().map(attribute::get).filter(gains -> !gains.isNone()).map(ShapeGains::format)
                .orElse(Command.LIGHT_LINKS.title()));
        disabledReason.set(Command.LINK.disabledReason(state));
    }
}
