package lightning.editor.window.widget;

import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import org.jspecify.annotations.Nullable;

/** Slider with a number field. The track shows the color of each value. */
final class ColorSlider extends VBox {
    private static final int SUBSTEPS_PER_STEP = 100;
    private static final int KEY_STEPS = 20;

    private final NumberSetting setting;
    private final Scale scale;
    private final NumberField field;
    private final Slider slider;
    private @Nullable Object gesture;
    private double startValue;
    private boolean isUpdating;

    /**
     * Mapping of values to positions on the track.
     *
     * @param min  value at the left end
     * @param max  value at the right end
     * @param toPosition  converts a value to a position, in any unit
     * @param toValue  converts a position to a value
     */
    record Scale(double min, double max, DoubleUnaryOperator toPosition, DoubleUnaryOperator toValue) {
        static Scale linear(double min, double max) {
            return new Scale(min, max, DoubleUnaryOperator.identity(), DoubleUnaryOperator.identity());
        }

        /** Returns the value at a fraction of the track, 0…1. */
        double valueAt(double fraction) {
            double left = toPosition.applyAsDouble(min);
            return toValue.applyAsDouble(left + fraction * (toPosition.applyAsDouble(max) - left));
        }
    }

    ColorSlider(String label, String title, Scale scale, NumberSetting setting) {
        this.setting = setting;
        this.scale = scale;
        field = new NumberField(title, setting);
        slider = new Slider(scale.toPosition().applyAsDouble(scale.min()), scale.toPosition().applyAsDouble(scale.max()), 0);
        slider.setAccessibleText(Messages.tr("{0} slider", title));
        slider.setBlockIncrement((slider.getMax() - slider.getMin()) / KEY_STEPS);
        slider.getStyleClass().add("color-slider");
        HBox.setHgrow(slider, Priority.ALWAYS);
        slider.addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> startDrag());
        slider.addEventFilter(MouseEvent.MOUSE_RELEASED, _ -> gesture = null);
        slider.addEventFilter(KeyEvent.KEY_PRESSED, this::handleKey);
        slider.valueProperty().addListener((_, _, now) -> slide(now.doubleValue()));
        Label name = new Label(label);
        name.setLabelFor(slider);
        name.getStyleClass().add("slider-name");
        HBox row = new HBox(name, slider, field);
        row.getStyleClass().add("number-row");
        getChildren().addAll(row, new RefusalLabel(List.of(field)));
    }

    /** Shows a value, and the color of each value along the track. */
    void show(double value, DoubleFunction<Rgb> color) {
        field.show(value);
        updateThumb();
        slider.setStyle("-track-paint: " + DisplayColors.gradient(share -> color.apply(scale.valueAt(share))) + ";");
    }

    /** Clears the slider: thumb at the left, no track colors. */
    void showNothing() {
        field.showNothing();
        isUpdating = true;
        slider.setValue(slider.getMin());
        isUpdating = false;
        slider.setStyle("");
    }

    void revert() {
        field.revert();
    }

    private void updateThumb() {
        isUpdating = true;
        slider.setValue(scale.toPosition().applyAsDouble(Math.clamp(field.value(), scale.min(), scale.max())));
        isUpdating = false;
    }

    private void startDrag() {
        gesture = new Object();
        startValue = field.value();
    }

    private void slide(double position) {
        if (isUpdating) {
            return;
        }
        double substep = setting.steps().step() / SUBSTEPS_PER_STEP;
        double value = setting.steps().addSteps(0, Math.rint(scale.toValue().applyAsDouble(position) / substep) / SUBSTEPS_PER_STEP);
        setting.set(Math.clamp(value, scale.min(), scale.max()), gesture).ifPresentOrElse(field::refuse, field::revert);
        updateThumb();
    }

    private void handleKey(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && gesture != null) {
            setting.set(startValue, gesture);
            updateThumb();
            gesture = null;
            event.consume();
        }
    }
}
