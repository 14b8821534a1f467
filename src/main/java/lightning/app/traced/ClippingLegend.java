package lightning.app.traced;

import java.util.Locale;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import lightning.app.model.EditorModel;
import lightning.image.DisplayCurve;
import lightning.image.ViewTransform;
import lightning.text.Texts;

/** Which mark says what, while pixels that are cut off are marked. */
final class ClippingLegend extends HBox {
    ClippingLegend(EditorModel model) {
        setId("clipping-legend");
        setMouseTransparent(true);
        setAlignment(Pos.CENTER);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        setAccessibleText(Texts.of("Marks of pixels that are cut off"));
        getChildren().setAll(chip(Texts.of("brighter than white"), ViewTransform.OVER_WHITE, "black"),
                chip("black", ViewTransform.BLACK, "white"));
        visibleProperty().bind(model.viewProperty().map(view -> view.marked() && view.curve() != DisplayCurve.FALSE));
        managedProperty().bind(visibleProperty());
    }

    private static Label chip(String text, int rgb, String ink) {
        var label = new Label(text);
        label.setStyle(String.format(Locale.ROOT, "-fx-background-color: #%06X; -fx-text-fill: %s; -fx-padding: 2 8 2 8;", rgb, ink));
        return label;
    }
}
