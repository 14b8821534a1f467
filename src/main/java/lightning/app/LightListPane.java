package lightning.app;

import javafx.scene.layout.VBox;

/** The lights of the scene. */
public final class LightListPane extends VBox {
    public LightListPane(EditorModel model) {
        setId("lights");
    }
}
