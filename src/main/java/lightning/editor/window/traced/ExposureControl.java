package lightning.editor.window.traced;

import java.util.List;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Slider;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import lightning.base.text.Measure;
import lightning.base.text.Texts;
import lightning.editor.document.Steps;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.StatusMessage;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.NumberField;
import lightning.render.image.ViewTransform;
import lightning.scene.Limits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignB;

/** The brightness of the view in stops, as a slider and a number. It is no part of the scene. */
final class ExposureControl extends HBox {
    private static final double MOST_STOPS = 8;
    private static final Steps STEPS = new Steps(0.1, -MOST_STOPS, MOST_STOPS);
    private static final double KEY_STOPS = 0.25;
    /** So that a pixel is not much more than a tenth of a stop. */
    private static final double TRACK = 136;

    private final ObjectProperty<ViewTransform> view;
    private final StatusMessage message;
    private final Slider slider = new Slider(-MOST_STOPS, MOST_STOPS, 0);
    private boolean showing;

    ExposureControl(ObjectProperty<ViewTransform> view, StatusMessage message) {
        this.view = view;
        this.message = message;
        slider.setId("exposure");
        slider.setAccessibleText(Texts.of("Exposure"));
        slider.setBlockIncrement(KEY_STOPS);
        slider.setMinWidth(TRACK);
        slider.setPrefWidth(TRACK);
        slider.setOnMouseClicked(e -> {
            if (e.getClickCount() == 2) {
                slider.setValue(0);
            }
        });
        // What is dragged comes in tenths; what is typed stays as it is.
        slider.valueProperty().subscribe(v -> {
            if (!showing) {
                set(Math.rint(v.doubleValue() / STEPS.step()) / Math.rint(1 / STEPS.step()));
            }
        });
        var stops = new NumberField(Texts.of("Exposure in stops"), Gauge.of("exposure", STEPS, Measure.STOPS, (v, _) -> set(v)));
        stops.setId("exposure-stops");
        Tooltip.install(this, new Tooltip(Texts.of("Exposure of the view in stops; double-click for 0.\nNo part of the scene.")));
        setAlignment(Pos.CENTER);
        setSpacing(4);
        getChildren().setAll(List.<Node>of(new FontIcon(MaterialDesignB.BRIGHTNESS_6), slider, stops));
        view.subscribe(now -> {
            showing = true;
            slider.setValue(now.exposure());
            showing = false;
            stops.show(now.exposure());
        });
    }

    private Optional<String> set(double stops) {
        try {
            Limits.range("exposure", stops, -MOST_STOPS, MOST_STOPS);
        } catch (IllegalArgumentException e) {
            message.show(Sentence.of(e));
            return Optional.of(e.getMessage());
        }
        view.set(view.get().withExposure(stops));
        return Optional.empty();
    }
}
