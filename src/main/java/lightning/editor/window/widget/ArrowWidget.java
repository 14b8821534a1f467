package lightning.editor.window.widget;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;

/**
 * A number with a name and an arrow (paper §3.2): drag the arrow up or down or the name sideways, click the arrow's upper or
 * lower half for a step, or type a value or a sum.
 */
public final class ArrowWidget extends VBox {
    private final NumberField field;
    private final DisabledReason disabledReason;

    /**
     * @param label what stands before the number, without its unit
     * @param title the name in full, for screen readers
     */
    public ArrowWidget(String label, String title, NumberSetting setting) {
        field = new NumberField(title, setting);
        Label name = new FieldLabel(label, setting, field);
        name.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(name, Priority.ALWAYS);
        HBox row = new HBox(name, field, new ArrowPad(setting, field));
        row.getStyleClass().add("number-row");
        getStyleClass().add("arrow-widget");
        getChildren().addAll(row, new RefusalLabel(List.of(field)));
        disabledReason = new DisabledReason(this, row);
    }

    /** Shows a value. */
    public void show(double value) {
        field.show(value);
    }

    /** Shows that there is no value. */
    public void showNothing() {
        field.showNothing();
    }

    /** Forgets what was typed. */
    public void revert() {
        field.revert();
    }

    /** Disables the widget and says why, a clause; or enables it. */
    public void setDisabledReason(Optional<String> reason) {
        if (reason.isPresent()) {
            field.revert();
        }
        disabledReason.set(reason);
    }
}
