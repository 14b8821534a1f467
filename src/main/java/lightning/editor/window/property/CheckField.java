package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Tooltip;
import lightning.editor.window.widget.ValueWidget;

/** Check box for a switch. */
final class CheckField extends CheckBox implements ValueWidget<Boolean> {
    /** @param onSwitched receives the new state */
    CheckField(String id, String text, String help, Consumer<Boolean> onSwitched) {
        super(text);
        setId(id);
        setTooltip(new Tooltip(help));
        setOnAction(_ -> onSwitched.accept(isSelected()));
    }

    @Override
    public void show(Boolean value) {
        setSelected(value);
    }

    @Override
    public void showNothing() {
        setSelected(false);
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        setDisable(reason.isPresent());
    }
}
