package lightning.app;

import javafx.scene.layout.BorderPane;

/** The ray-traced canvas. */
public final class TracedPane extends BorderPane {
    public TracedPane(EditorModel model) {
        setId("traced");
    }
}
