package lightning.app;

import javafx.geometry.Orientation;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.BorderPane;

/** Everything inside the editor's frame: traced picture, preview, and beside them the lights and their properties. */
public final class EditorWindow extends BorderPane {
    private static final double CANVASES = 0.74;
    private static final double LIST = 0.28;

    public EditorWindow(EditorModel model) {
        var canvases = new SplitPane(new TracedPane(model), new PreviewPane(model));
        var side = new SplitPane(new LightListPane(model), new PropertyPane(model));
        side.setOrientation(Orientation.VERTICAL);
        side.setDividerPositions(LIST);
        var all = new SplitPane(canvases, side);
        all.setDividerPositions(CANVASES);
        SplitPane.setResizableWithParent(side, false);
        setCenter(all);
    }
}
