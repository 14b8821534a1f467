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
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.CommandPalette;
import lightning.editor.window.command.EditorDialogs;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.command.UndoKeys;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.preview.PreviewPane;
import lightning.editor.window.property.DomeFiles;
import lightning.editor.window.property.ListTabs;
import lightning.editor.window.property.SidePane;
import lightning.editor.window.timeline.MotionRecording;
import lightning.editor.window.timeline.Playback;
import lightning.editor.window.timeline.ShotExportWindow;
import lightning.editor.window.welcome.LessonBar;

/** Content of the editor's window: traced picture, preview, and the lists and properties next to them. */
public final class EditorWindow implements AutoCloseable {
    private final EditorLayout layout;
    private final PreviewPane preview;
    private final FileActions files;
    private final PanelWindows panels;
    private final DockedPanels docks;
    private final VBox bars;
    private final EditorModel model;
    private final EditorMenu menu;
    private final SidePane side;
    private final LessonBar lessons;
    private final ListTabs lists;
    private final BooleanProperty fullScreen = new SimpleBooleanProperty();

    /** Adds all panes to a layout that already contains the traced picture. */
    EditorWindow(EditorLayout layout, EditorModel model, FileActions files, EditorDialogs notices) {
        this.layout = layout;
        this.files = files;
        this.model = model;
        preview = new PreviewPane(model);
        panels = new PanelWindows(model, this::window);
        panels.registerCommands(model.commands());
        model.commands().setAction(Command.ABOUT, () -> AboutDialog.show(notices));
        model.commands().setToggle(Command.FULL_SCREEN, fullScreen, this::toggleFullScreen);
        docks = new DockedPanels(model, this::window, new Playback(model.editor(), model.picture(), model.commands()),
                new MotionRecording(model, () -> PathPrompt.ofSystem(window(), model.fileImporter().folder())));
        model.commands().setAction(Command.EXPORT_SHOT, () -> new ShotExportWindow(model, window()).show());
        menu = new EditorMenu(model, files);
        model.commands().setAction(Command.PALETTE, () -> CommandPalette.open(window(), menu, model.commands()));
        var tools = new EditorToolBar(model);
        tools.visibleProperty().bind(model.layout().panelsHiddenProperty().not());
        tools.managedProperty().bind(tools.visibleProperty());
        lessons = new LessonBar(model);
        bars = new VBox(menu, tools, lessons);
        new WelcomePage(layout, model, files, lessons, this::focus);
        side = new SidePane(model);
        lists = new ListTabs(model);
        layout.setPanes(bars, preview, lists, side, new StatusBar(model.editor(), model.picture(), model.commands()));
        lists.worldShownProperty().subscribe(layout::showLists);
        model.previewSettings().fogHandlesProperty().bind(lists.worldShownProperty());
        layout.bindTo(model.layout());
        layout.addDocks(model.layout(), docks);
        new PanelFocus(this::window, List.of(preview.canvas(), lists, side, docks.left(), docks.below()))
                .registerCommands(model.commands());
        layout.addEventFilter(KeyEvent.KEY_PRESSED, e -> {
            if (e.getCode() == KeyCode.TAB && !e.isShiftDown() && !e.isControlDown() && !e.isAltDown() && layout.isOverPictures()) {
                // A focused button of a hidden panel would pass its focus on to another control, to which Tab would belong.
                focus();
                model.commands().run(Command.HIDE_PANELS);
                e.consume();
            }
        });
        UndoKeys.install(layout, model.commands());
        CommandKeys.explainDisabled(layout, model.commands());
        layout.setOnDragOver(this::dragOver);
        layout.setOnDragDropped(this::handleDrop);
    }

    private void toggleFullScreen() {
        var stage = (Stage) window();
        if (!fullScreen.isBound()) {
            // Escape cancels tasks and prompts, so it must not leave the full screen.
            stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
            stage.setFullScreenExitHint(Messages.tr("Press F11 to exit full screen"));
            fullScreen.bind(stage.fullScreenProperty());
        }
        stage.setFullScreen(!stage.isFullScreen());
    }

    /** Adds a bar below the tool bar. */
    void addBar(Node bar) {
        bars.getChildren().add(bar);
    }

    /** Shows panels in windows of their own. The editor's window must be open. */
    void showPanelWindows() {
        docks.showWindows();
    }

    /** Gives the preview the keyboard focus. */
    void focus() {
        // Split panes add their content to the scene only when they are styled.
        layout.applyCss();
        preview.canvas().requestFocus();
    }

    private Window window() {
        return layout.getScene().getWindow();
    }

    private static boolean isScene(File file) {
        return StartupFiles.canOpen(file.getName());
    }

    private void dragOver(DragEvent e) {
        if (e.getDragboard().getFiles().stream().anyMatch(file -> isScene(file) || DomeFiles.canAdd(file))) {
            e.acceptTransferModes(TransferMode.COPY);
        }
        e.consume();
    }

    private void handleDrop(DragEvent e) {
        e.setDropCompleted(openDropped(e.getDragboard().getFiles()));
        e.consume();
    }

    /** Returns steps that create panels ahead of their first use. */
    Stream<Runnable> preloadSteps() {
        return Stream.of(side.preloadSteps(), lists.preloadSteps(), menu.preloadSteps(), panels.preloadSteps(), docks.preloadSteps())
                .flatMap(Function.identity());
    }

    /** Opens the first scene among dropped files; without one, adds the first environment image. Returns whether one of them is either. */
    boolean openDropped(List<File> droppedFiles) {
        Optional<File> scene = droppedFiles.stream().filter(EditorWindow::isScene).findFirst();
        scene.ifPresent(f -> files.load(f.toPath()));
        return scene.isPresent() || DomeFiles.addFirst(model, droppedFiles);
    }

    @Override
    public void close() {
        lessons.close();
        panels.close();
        docks.close();
        preview.close();
    }
}
