package lightning.editor.window.traced;

import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.Background;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;

/** Row of labeled colors over the traced picture, visible while these colors are used. */
class Legend extends HBox {
    /**
     * Creates an empty legend.
     *
     * @param accessibleText text for screen readers
     */
    Legend(String id, String accessibleText, ObservableValue<Boolean> visible) {
        setId(id);
        getStyleClass().add("legend");
        setMouseTransparent(true);
        setAlignment(Pos.CENTER);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        setAccessibleText(accessibleText);
        visibleProperty().bind(visible);
        managedProperty().bind(visibleProperty());
    }

    /**
     * Adds a labeled color.
     *
     * @param rgb 0xRRGGBB
     * @param dark true for white text, false for black text
     */
    final void add(String text, int rgb, boolean dark) {
        var label = new Label(text);
        label.getStyleClass().add(dark ? "on-dark" : "on-pale");
        label.setBackground(Background.fill(Color.rgb(rgb >> 16 & 0xFF, rgb >> 8 & 0xFF, rgb & 0xFF)));
        getChildren().add(label);
    }
}
