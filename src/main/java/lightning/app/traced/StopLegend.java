package lightning.app.traced;

import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.Background;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import lightning.app.model.EditorModel;
import lightning.image.DisplayCurve;
import lightning.image.FalseColor;
import lightning.text.Texts;

/** Which color stands for which stop, while the picture is shown in such colors. */
final class StopLegend extends HBox {
    private static final int DARK = 3 * 0x60;

    StopLegend(EditorModel model) {
        setId("stop-legend");
        setMouseTransparent(true);
        setAlignment(Pos.CENTER);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        setAccessibleText(Texts.of("Stops from middle grey, by color"));
        for (FalseColor.Band band : FalseColor.bands()) {
            int rgb = band.rgb();
            var label = new Label(band.stop() > 0 ? "+" + band.stop() : String.valueOf(band.stop()));
            boolean dark = (rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF) + (rgb & 0xFF) < DARK;
            label.getStyleClass().add(dark ? "dark-stop" : "stop");
            label.setBackground(Background.fill(Color.rgb(rgb >> 16 & 0xFF, rgb >> 8 & 0xFF, rgb & 0xFF)));
            getChildren().add(label);
        }
        visibleProperty().bind(model.viewProperty().map(view -> view.curve() == DisplayCurve.FALSE));
        managedProperty().bind(visibleProperty());
    }
}
