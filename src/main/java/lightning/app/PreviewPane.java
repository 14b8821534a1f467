package lightning.app;

import javafx.scene.layout.BorderPane;

/** The interactive preview. */
public final class PreviewPane extends BorderPane {
    public PreviewPane(EditorModel model) {
        setId("preview");
    }
}
