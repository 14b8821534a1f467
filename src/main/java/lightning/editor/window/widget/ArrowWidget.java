package lightning.editor.window.widget;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.document.StepRange;
import org.jspecify.annotations.Nullable;

/**
 * Number field with a label and an arrow (paper §3.2), and with a slider if its bounds are narrow. Drag the arrow vertically, the label
 * sideways or the slider, click the arrow's halves to step, or type a value or an expression.
 */
public final class ArrowWidget extends VBox implements ValueWidget<Double> {
    private final NumberField field;
    /** Null if the number has no narrow bounds. */
    private final @Nullable ValueSlider slider;
    private final DisabledReason disabledReason;

    /**
     * @param label  label of the number, without its unit
     * @param title  full name for screen readers
     */
    public ArrowWidget(String label, String title, NumberSetting setting) {
        field = new NumberField(title, setting);
        Label name = new FieldLabel(label, setting, field);
        name.setMinWidth(USE_PREF_SIZE);
        name.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(name, Priority.ALWAYS);
        StepRange steps = setting.steps();
        slider = !ValueSlider.serves(steps) ? null
                : new ValueSlider(title, ValueSlider.Scale.linear(steps.min(), steps.max()), setting, field);
        HBox row = slider == null ? new HBox(name, field, new ArrowPad(setting, field))
                : new HBox(name, slider, field, new ArrowPad(setting, field));
        row.getStyleClass().add("number-row");
        getStyleClass().add("arrow-widget");
        getChildren().addAll(row, new RefusalLabel(List.of(field)));
        disabledReason = new DisabledReason(this, row);
    }

    @Override
    public void show(Double value) {
        field.show(value);
        if (slider != null) {
            slider.update();
        }
    }

    @Override
    public void showNothing() {
        field.showNothing();
        if (slider != null) {
            slider.showNothing();
        }
    }

    @Override
    public void revert() {
        field.revert();
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        if (reason.isPresent()) {
            field.revert();
        }
        disabledReason.set(reason);
    }
}
