package lightning.editor.window.widget;

import java.util.List;
import java.util.function.DoubleFunction;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.math.Rgb;

/** Slider with a number field. The track shows the color of each value. */
final class ColorSlider extends VBox {
    private final ValueSlider.Scale scale;
    private final NumberField field;
    private final ValueSlider slider;

    ColorSlider(String label, String title, ValueSlider.Scale scale, NumberSetting setting) {
        this.scale = scale;
        field = new NumberField(title, setting);
        slider = new ValueSlider(title, scale, setting, field);
        slider.getStyleClass().add("color-slider");
        HBox.setHgrow(slider, Priority.ALWAYS);
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
        slider.update();
        slider.setStyle("-track-paint: " + DisplayColors.gradient(share -> color.apply(scale.valueAt(share))) + ";");
    }

    /** Clears the slider: thumb at the left, no track colors. */
    void showNothing() {
        field.showNothing();
        slider.showNothing();
        slider.setStyle("");
    }

    void revert() {
        field.revert();
    }
}
