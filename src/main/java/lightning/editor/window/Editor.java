package lightning.editor.window;

import java.nio.file.Path;
import java.util.List;
import javafx.beans.Observable;
import javafx.scene.control.ButtonType;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.FileThread;
import lightning.editor.document.Recovery;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.command.Notices;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.PreviewLook;
import lightning.editor.window.widget.Looks;
import lightning.render.image.ViewTransform;

/** The editor of one document in one window, from opening to closing. */
public final class Editor implements AutoCloseable {
    private final Stage stage;
    private final FirstSight sight;
    private final Preferences preferences;
    private final FileThread thread;
    private final Notices notices;
    private final FileActions files;
    private final EditorModel model;
    private final EditorWindow window;
    private final DiskBar disk;

    /**
     * Opens the window.
     *
     * @param sight     the document's model and picture; closed with the editor
     * @param thread    reads and writes files; closed with the editor
     * @param mostWidth the largest size of the window, pixels: the screen's; likewise {@code mostHeight}
     */
    Editor(Stage stage, FirstSight sight, Preferences preferences, FileThread thread, FilePrompt prompt, double mostWidth,
            double mostHeight) {
        this.stage = stage;
        this.sight = sight;
        this.preferences = preferences;
        this.thread = thread;
        notices = new Notices(stage);
        model = sight.model();
        files = new FileActions(model, prompt, notices, preferences, this::closeWindow);
        window = new EditorWindow(sight.frame(), model, files, notices);
        disk = new DiskBar(model.workbench(), model.commands(), thread.window(), files::compareWithDisk);
        window.addLine(disk);
        model.editor().situationProperty()
                .subscribe(now -> stage.setTitle((now.dirty() ? "• " : "") + model.editor().document().name() + " – Lightning"));
        stage.focusedProperty().subscribe(_ -> disk.look());
        stage.setOnCloseRequest(e -> {
            e.consume();
            files.leave(() -> {
                remember();
                closeOthers();
                stage.hide();
            });
        });
        preferences.opened(model.editor().document().file());
        keepChoices();
        EditorStage.show(stage, sight.frame(), preferences, mostWidth, mostHeight);
        window.focus();
    }

    EditorModel model() {
        return model;
    }

    EditorWindow window() {
        return window;
    }

    /** Whether the picture is there, and nothing is being done about another. */
    boolean rests() {
        return model.picture().frame() != null && model.fileWork().file() == null
                && model.editor().situationProperty().get().inWork().isEmpty();
    }

    public FileActions files() {
        return files;
    }

    /** Asks about edits that a crash left unsaved, until some are wanted. */
    void offer(List<Recovery.Found> all) {
        for (Recovery.Found found : all) {
            ButtonType answer = notices.recover(found).orElse(null);
            if (answer == Notices.RECOVER) {
                files.recover(found);
                return;
            }
            if (answer == Notices.FORGET) {
                thread.inTurn(() -> {
                    found.delete();
                    return found;
                }, _ -> {}, why -> notices.failed(Texts.of("The edits could not be discarded"), why));
            }
        }
    }

    /** Says that a scene could not be opened, and goes on when it was read. */
    void failed(Path file, Exception why) {
        notices.failedAndRead(Texts.of("{0} could not be opened", Quote.path(file)), why);
    }

    private void closeWindow() {
        stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
    }

    /** Choices are kept at once, for the case of a crash. */
    private void keepChoices() {
        PreviewLook look = model.previewLook();
        for (Observable choice : List.of(model.precisionProperty(), model.picture().viewProperty().map(ViewTransform::curve),
                look.glowingProperty(),
                look.sizeProperty(), model.commands().keys().changesProperty(), model.arrangement().canvasesProperty(),
                model.speechProperty(),
                model.machineChoice().hostsProperty(), model.machineChoice().certificateProperty(),
                model.commands().switched(Command.LIGHT_THEME).orElseThrow())) {
            choice.addListener(_ -> remember());
        }
    }

    private void remember() {
        preferences.set("width", stage.getScene().getWidth());
        preferences.set("height", stage.getScene().getHeight());
        preferences.set("theme", Looks.worn().name());
        model.speechProperty().get().remember(preferences);
        preferences.set("curve", model.picture().viewProperty().get().curve().name());
        model.previewLook().remember(preferences);
        model.commands().keys().remember(preferences);
        model.arrangement().remember(preferences);
        model.machineChoice().remember(preferences);
        preferences.set("precision", model.precisionProperty().get().name());
        preferences.save();
    }

    /** Windows go before the one that owns them: the toolkit may touch one once more that its owner took with it. */
    private void closeOthers() {
        List.copyOf(Window.getWindows()).reversed().stream().filter(window -> window != stage).forEach(Window::hide);
    }

    @Override
    public void close() {
        closeOthers();
        disk.close();
        window.close();
        sight.close();
        thread.close();
    }
}
