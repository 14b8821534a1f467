package lightning.app;

import java.io.File;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.VBox;
import javafx.stage.Window;
import lightning.app.animation.AnimationWindow;
import lightning.app.command.FileActions;
import lightning.app.command.Notices;
import lightning.app.command.UndoKeys;
import lightning.app.model.EditorModel;
import lightning.app.preview.PreviewPane;
import lightning.app.property.LightListPane;
import lightning.app.property.SidePane;
import lightning.app.traced.TracedPane;
import lightning.edit.Command;

/** Everything inside the editor's frame: traced picture, preview, and beside them the lights and their properties. */
public final class EditorWindow extends BorderPane implements AutoCloseable {
    /** The share of the two pictures in the window's width. */
    static final double CANVASES = 0.74;
    private static final double LIST = 0.28;

    private final PreviewPane preview;
    private final TracedPane traced;
    private final FileActions files;
    private final Panels panels;

    EditorWindow(EditorModel model, FileActions files, Notices notices) {
        this.files = files;
        setId("editor");
        getStyleClass().add("editor");
        preview = new PreviewPane(model);
        traced = new TracedPane(model);
        var canvases = new SplitPane(traced, preview);
        var side = new SplitPane(new LightListPane(model), new SidePane(model));
        side.setOrientation(Orientation.VERTICAL);
        side.setDividerPositions(LIST);
        var all = new SplitPane(canvases, side);
        all.setDividerPositions(CANVASES);
        SplitPane.setResizableWithParent(side, false);
        panels = new Panels(model, this::window);
        setTop(new VBox(new EditorMenu(model, files, traced, preview, notices, panels), new EditorToolBar(model, panels)));
        setCenter(all);
        setBottom(new StatusLine(model));
        model.setAction(Command.MAKE_ANIMATION, () -> new AnimationWindow(model, window()).show());
        UndoKeys.take(this, model);
        setOnDragOver(this::dragOver);
        setOnDragDropped(this::dropped);
    }

    /** Puts a line below the tool bar. */
    void addLine(Node line) {
        ((VBox) getTop()).getChildren().add(line);
    }

    /** The keyboard takes lights at once. */
    void focus() {
        // What lies between the bars of the split panes is in the window only when they have their looks.
        applyCss();
        preview.canvas().requestFocus();
    }

    private Window window() {
        return getScene().getWindow();
    }

    private static boolean isScene(File file) {
        return file.getName().endsWith(".jen");
    }

    private void dragOver(DragEvent e) {
        if (e.getDragboard().getFiles().stream().anyMatch(EditorWindow::isScene)) {
            e.acceptTransferModes(TransferMode.COPY);
        }
        e.consume();
    }

    private void dropped(DragEvent e) {
        e.setDropCompleted(drop(e.getDragboard().getFiles()));
        e.consume();
    }

    /** Opens the first scene among files; returns whether there is one. */
    boolean drop(List<File> dropped) {
        Optional<File> scene = dropped.stream().filter(EditorWindow::isScene).findFirst();
        scene.ifPresent(f -> files.load(f.toPath()));
        return scene.isPresent();
    }

    @Override
    public void close() {
        panels.close();
        files.close();
        preview.close();
        traced.close();
    }
}
