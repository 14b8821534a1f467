package lightning.editor.window.widget;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.document.StepRange;
import lightning.scene.value.ColorTemperature;
import lightning.scene.value.SceneLimits;

/** Slider for a light's color temperature, with presets. */
public final class TemperatureSlider extends VBox implements ValueWidget<Double> {
    private static final double STEP = 100;
    private static final List<Preset> PRESETS = List.of(new Preset(Messages.key("Candle"), 1900),
            new Preset(Messages.key("Tungsten"), 3200), new Preset(Messages.key("Daylight"), 5600),
            new Preset(Messages.key("Neutral"), ColorTemperature.NEUTRAL), new Preset(Messages.key("Shade"), 8000));

    private final ColorSlider slider;
    private final DisabledReason disabledReason;

    private record Preset(String name, double kelvin) {}

    /** @param setter receives kelvin */
    public TemperatureSlider(NumberSetting.Setter setter) {
        slider = new ColorSlider("K", "temperature",
                new ValueSlider.Scale(ColorTemperature.MIN, ColorTemperature.MAX, Math::log, Math::exp),
                NumberSetting.of("temperature", new StepRange(STEP, ColorTemperature.MIN, ColorTemperature.MAX), NumberUnit.KELVIN,
                        setter));
        var presets = new FlowPane();
        presets.getStyleClass().add("presets");
        for (Preset preset : PRESETS) {
            var button = new Button(Messages.tr(preset.name()));
            button.getStyleClass().add("small");
            button.setTooltip(new Tooltip(SceneLimits.format(preset.kelvin()) + " K"));
            button.setOnAction(_ -> setter.set(preset.kelvin(), null));
            presets.getChildren().add(button);
        }
        var box = new VBox(slider, presets);
        box.getStyleClass().add("color-sliders");
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box, Messages.tr("Color temperature: multiplies the light's color"));
    }

    @Override
    public void show(Double kelvin) {
        slider.show(kelvin, ColorTemperature::rgb);
    }

    @Override
    public void showNothing() {
        slider.showNothing();
    }

    @Override
    public void revert() {
        slider.revert();
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }
}
