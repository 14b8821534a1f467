package lightning.app;

import javafx.scene.layout.VBox;

/** The property editor of the selected light and the scene (paper §3.2, Figure 5). */
public final class PropertyPane extends VBox {
    public PropertyPane(EditorModel model) {
        setId("properties");
    }
}
