package lightning.editor.window.mixer;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.layout.VBox;
import javafx.stage.Popup;
import javafx.util.Subscription;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.editor.document.HsvColor;
import lightning.editor.document.MixerChannel;
import lightning.editor.document.StepRange;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.NumberSetting;
import lightning.editor.window.widget.TemperatureSlider;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Color picker below a strip's color chip; closes when the user clicks elsewhere. Sets the color of all selected strips. */
final class ColorPopup {
    private static final double WIDTH = 300;

    private final MixerModel model;
    private final MixerChannel channel;
    private final double maxValue;
    private final ColorSliders sliders;

    ColorPopup(MixerModel model, MixerChannel channel) {
        this.model = model;
        this.channel = channel;
        maxValue = channel instanceof MixerChannel.OfLightGroup ? 1 : SceneLimits.MAX_LIGHT_COLOR;
        sliders = channel instanceof MixerChannel.OfLightGroup group
                ? ColorSliders.forSurface(group.name(), Messages.tr("Gel: multiplies the color of every light in the group"), 1,
                        new Target())
                : new ColorSliders(new Target());
    }

    void show(Node anchor) {
        var temperature = new TemperatureSlider(
                (kelvin, gesture) -> model.editSelected(channel, (scene, c) -> c.withTemperature(scene, kelvin), gesture));
        var pane = channel.lightName().isPresent() ? new VBox(sliders, temperature) : new VBox(sliders);
        pane.getStyleClass().addAll("color-popup", "root");
        ColorTheme.applyTo(pane);
        pane.setId("color-popup");
        pane.setPrefWidth(WIDTH);
        var popup = new Popup();
        popup.setAutoHide(true);
        popup.setHideOnEscape(true);
        popup.getContent().add(pane);
        ColorTheme.style(popup.getScene());
        Subscription subscription = model.editor().sceneProperty().subscribe(scene -> {
            if (channel.isIn(scene)) {
                channel.values(scene).color().ifPresent(sliders::show);
                channel.temperature(scene).ifPresent(temperature::show);
            } else {
                popup.hide();
            }
        });
        popup.setOnHidden(_ -> subscription.unsubscribe());
        Bounds bounds = anchor.localToScreen(anchor.getBoundsInLocal());
        popup.show(anchor, bounds.getMinX(), bounds.getMaxY() + 4);
    }

    private NumberSetting gauge(String title, BiFunction<Rgb, Double, Rgb> setter) {
        return NumberSetting.of(title, new StepRange(0.1, 0, maxValue), (v, gesture) -> set(c -> setter.apply(c, v), gesture));
    }

    private interface ColorEdit {
        Rgb apply(Rgb color);
    }

    private Optional<String> set(ColorEdit edit, @Nullable Object gesture) {
        return model.editSelected(channel, (scene, c) -> c.with(scene, v -> v.withColor(v.color().map(edit::apply))), gesture);
    }

    private final class Target implements ColorSliders.Target {
        @Override
        public NumberSetting red() {
            return gauge("red", (c, v) -> new Rgb(v, c.g(), c.b()));
        }

        @Override
        public NumberSetting green() {
            return gauge("green", (c, v) -> new Rgb(c.r(), v, c.b()));
        }

        @Override
        public NumberSetting blue() {
            return gauge("blue", (c, v) -> new Rgb(c.r(), c.g(), v));
        }

        @Override
        public Optional<String> hsv(HsvColor color, @Nullable Object gesture) {
            return set(_ -> color.rgb(), gesture);
        }
    }
}
