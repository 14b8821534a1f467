package lightning.editor.window;

import java.io.File;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Node;
import javafx.scene.input.DragEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.animation.AnimationWindow;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.CommandPalette;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.command.Notices;
import lightning.editor.window.command.UndoKeys;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.preview.PreviewPane;
import lightning.editor.window.property.ListTabs;
import lightning.editor.window.property.SidePane;
import lightning.editor.window.timeline.Playback;
import lightning.editor.window.timeline.ShotExportWindow;
import lightning.editor.window.timeline.TimelinePane;

/** Everything inside the editor's frame: traced picture, preview, and beside them the lights and their properties. */
public final class EditorWindow implements AutoCloseable {
    private final Runnable makeTimeline;
    private final EditorFrame frame;
    private final PreviewPane preview;
    private final FileActions files;
    private final Panels panels;
    private final VBox bars;
    private final EditorMenu menu;
    private final SidePane side;
    /** Null before it was first shown. */
    private TimelinePane timeline;
    private final BooleanProperty fullScreen = new SimpleBooleanProperty();

    /** Fills a frame, in which the traced picture stands already. */
    EditorWindow(EditorFrame frame, EditorModel model, FileActions files, Notices notices) {
        this.frame = frame;
        this.files = files;
        preview = new PreviewPane(model);
        panels = new Panels(model, this::window);
        panels.addTo(model.commands());
        model.commands().setAction(Command.ABOUT, () -> About.show(notices));
        AnimationWindow.addTo(model, this::window);
        model.commands().setSwitch(Command.FULL_SCREEN, fullScreen, this::switchFullScreen);
        var playback = new Playback(model.editor(), model.picture(), model.commands());
        model.commands().setAction(Command.EXPORT_SHOT, () -> new ShotExportWindow(model, window()).show());
        menu = new EditorMenu(model, files);
        model.commands().setAction(Command.PALETTE, () -> CommandPalette.open(window(), menu, model.commands()));
        var tools = new EditorToolBar(model.editor(), model.commands(), model.precisionProperty());
        tools.visibleProperty().bind(model.arrangement().panelsHiddenProperty().not());
        tools.managedProperty().bind(tools.visibleProperty());
        bars = new VBox(menu, tools);
        side = new SidePane(model);
        frame.fill(bars, preview, new ListTabs(model.editor(), model.commands()), side,
                new StatusLine(model.editor(), model.picture(), model.commands()));
        frame.follow(model.arrangement());
        makeTimeline = frame.addTimeline(model.arrangement(), () -> {
            timeline = new TimelinePane(model, playback);
            return timeline;
        });
        frame.addEventFilter(KeyEvent.KEY_PRESSED, e -> {
            if (e.getCode() == KeyCode.TAB && !e.isShiftDown() && !e.isControlDown() && !e.isAltDown() && frame.isOverPictures()) {
                model.commands().run(Command.HIDE_PANELS);
                e.consume();
            }
        });
        UndoKeys.take(frame, model.commands());
        CommandKeys.explain(frame, model.commands());
        frame.setOnDragOver(this::dragOver);
        frame.setOnDragDropped(this::dropped);
    }

    private void switchFullScreen() {
        var stage = (Stage) window();
        if (!fullScreen.isBound()) {
            // Escape cancels and ends what is asked.
            stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
            stage.setFullScreenExitHint(Texts.of("F11 leaves the full screen"));
            fullScreen.bind(stage.fullScreenProperty());
        }
        stage.setFullScreen(!stage.isFullScreen());
    }

    /** Puts a line below the tool bar. */
    void addLine(Node line) {
        bars.getChildren().add(line);
    }

    /** The keyboard takes lights at once. */
    void focus() {
        // What lies between the bars of the split panes is in the window only when they have their looks.
        frame.applyCss();
        preview.canvas().requestFocus();
    }

    private Window window() {
        return frame.getScene().getWindow();
    }

    private static boolean isScene(File file) {
        return Opening.isNamedSo(file.getName());
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

    /** What can be made before somebody asks for it, a step after the other. */
    Stream<Runnable> ahead() {
        return Stream.of(side.ahead(), menu.ahead(), panels.ahead(), Stream.of(makeTimeline)).flatMap(Function.identity());
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
        if (timeline != null) {
            timeline.close();
        }
        preview.close();
    }
}
