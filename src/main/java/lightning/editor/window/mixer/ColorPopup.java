package lightning.editor.window.mixer;

import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.layout.VBox;
import javafx.stage.Popup;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.document.MixerChannel;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.TemperatureSlider;
import lightning.scene.value.SceneLimits;

/** Color picker below a strip's color chip; closes when the user clicks elsewhere. Sets the color of all selected strips. */
final class ColorPopup {
    private static final double WIDTH = 300;

    private final MixerModel model;
    private final MixerChannel channel;
    private final ColorSliders sliders;

    ColorPopup(MixerModel model, MixerChannel channel) {
        this.model = model;
        this.channel = channel;
        ColorSliders.Target target = (change, gesture) -> model.editSelected(channel,
                (scene, c) -> c.with(scene, v -> v.withColor(v.color().map(change))), gesture);
        sliders = channel instanceof MixerChannel.OfLightGroup group
                ? new ColorSliders(group.name(), Messages.tr("Gel: multiplies the color of every light in the group"), 1, target)
                : new ColorSliders("", Messages.tr("Light color"), SceneLimits.MAX_LIGHT_COLOR, target);
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
}
