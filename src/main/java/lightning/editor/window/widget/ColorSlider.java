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
import lightning.base.text.Texts;

/** A slider whose track shows the colours that it would give, with a field for values in full. */
final class ColorSlider extends VBox {
    private static final int GRAINS_PER_STEP = 100;
    private static final int KEYS_PER_TRACK = 20;

    private final Gauge gauge;
    private final Scale scale;
    private final NumberField field;
    private final Slider slider;
    private Object gesture;
    private double from;
    private boolean showing;

    /**
     * Where the values lie along the track.
     *
     * @param min   the value at the left end
     * @param max   the value at the right end
     * @param place from a value to its place, in any unit
     * @param value from a place to its value
     */
    record Scale(double min, double max, DoubleUnaryOperator place, DoubleUnaryOperator value) {
        static Scale even(double min, double max) {
            return new Scale(min, max, DoubleUnaryOperator.identity(), DoubleUnaryOperator.identity());
        }

        /** The value at a share, 0…1, of the way along the track. */
        double at(double share) {
            double left = place.applyAsDouble(min);
            return value.applyAsDouble(left + share * (place.applyAsDouble(max) - left));
        }
    }

    ColorSlider(String label, String title, Scale scale, Gauge gauge) {
        this.gauge = gauge;
        this.scale = scale;
        field = new NumberField(title, gauge);
        slider = new Slider(scale.place().applyAsDouble(scale.min()), scale.place().applyAsDouble(scale.max()), 0);
        slider.setAccessibleText(Texts.of("{0} slider", title));
        slider.setBlockIncrement((slider.getMax() - slider.getMin()) / KEYS_PER_TRACK);
        slider.getStyleClass().add("color-slider");
        HBox.setHgrow(slider, Priority.ALWAYS);
        slider.addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> begin());
        slider.addEventFilter(MouseEvent.MOUSE_RELEASED, _ -> gesture = null);
        slider.addEventFilter(KeyEvent.KEY_PRESSED, this::key);
        slider.valueProperty().addListener((_, _, now) -> slide(now.doubleValue()));
        Label name = new Label(label);
        name.setLabelFor(slider);
        name.getStyleClass().add("slider-name");
        HBox row = new HBox(name, slider, field);
        row.getStyleClass().add("number-row");
        getChildren().addAll(row, new Refusal(List.of(field)));
    }

    /** Shows a value, and along the track the colour that each value would give. */
    void show(double value, DoubleFunction<Rgb> color) {
        field.show(value);
        place();
        slider.setStyle("-track-paint: " + Paints.gradient(share -> color.apply(scale.at(share))) + ";");
    }

    /** Shows that there is no colour: the thumb rests at the left of a track without colours. */
    void showNothing() {
        field.showNothing();
        showing = true;
        slider.setValue(slider.getMin());
        showing = false;
        slider.setStyle("");
    }

    void revert() {
        field.revert();
    }

    private void place() {
        showing = true;
        slider.setValue(scale.place().applyAsDouble(Math.clamp(field.value(), scale.min(), scale.max())));
        showing = false;
    }

    private void begin() {
        gesture = new Object();
        from = field.value();
    }

    private void slide(double place) {
        if (showing) {
            return;
        }
        double grain = gauge.steps().step() / GRAINS_PER_STEP;
        double value = gauge.steps().from(0, Math.rint(scale.value().applyAsDouble(place) / grain) / GRAINS_PER_STEP);
        gauge.set(Math.clamp(value, scale.min(), scale.max()), gesture).ifPresentOrElse(field::refuse, field::revert);
        place();
    }

    private void key(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && gesture != null) {
            gauge.set(from, gesture);
            place();
            gesture = null;
            event.consume();
        }
    }
}
