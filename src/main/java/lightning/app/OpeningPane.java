package lightning.app;

import java.nio.file.Path;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.app.widget.PaneHeader;

/** The editor's panes before there is a scene in them; they say what is being read. */
final class OpeningPane extends BorderPane {

    OpeningPane(Path file) {
        setId("opening");
        getStyleClass().add("editor");
        String reading = "Reading " + file.getFileName() + " …";
        var panes = new SplitPane(pane("Ray traced", reading), pane("Preview", reading), side(reading));
        panes.setDividerPositions(EditorWindow.CANVASES / 2, EditorWindow.CANVASES);
        setCenter(panes);
    }

    private static BorderPane pane(String title, String text) {
        var note = new Label(text);
        note.getStyleClass().add("canvas-note");
        var canvas = new StackPane(note);
        canvas.getStyleClass().add("canvas");
        var pane = new BorderPane(canvas);
        pane.setTop(new PaneHeader(title));
        return pane;
    }

    private static VBox side(String text) {
        var note = new Label(text);
        note.getStyleClass().add("pane-note");
        var side = new VBox(new PaneHeader("Lights"), note);
        side.getStyleClass().add("lights");
        return side;
    }
}
