package lightning.editor.window.traced;

import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.Background;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;

/** What colors in the traced picture say, in a row over it, while they are there. */
class Legend extends HBox {
    /** @param accessibleText for who does not see it */
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
     * Adds what one color says.
     *
     * @param rgb  0xRRGGBB
     * @param dark whether white words are read on it better than black ones
     */
    final void add(String text, int rgb, boolean dark) {
        var label = new Label(text);
        label.getStyleClass().add(dark ? "on-dark" : "on-pale");
        label.setBackground(Background.fill(Color.rgb(rgb >> 16 & 0xFF, rgb >> 8 & 0xFF, rgb & 0xFF)));
        getChildren().add(label);
    }
}
