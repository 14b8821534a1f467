package lightning.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Executor;
import javafx.scene.control.ButtonType;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import lightning.app.command.FileActions;
import lightning.app.command.FilePrompt;
import lightning.app.command.Notices;
import lightning.app.model.EditorModel;
import lightning.app.model.Precision;
import lightning.app.model.Preferences;
import lightning.app.widget.Looks;
import lightning.edit.OpenDocument;
import lightning.edit.Recovery;
import lightning.image.DisplayCurve;
import lightning.jen.JenException;
import lightning.text.Quote;

/** The editor of one document in one window, from opening to closing. */
public final class Editor implements AutoCloseable {
    private final Stage stage;
    private final Preferences preferences = new Preferences(Folders.data());
    private final Recovery recovery = new Recovery(Folders.data().resolve("recovery"));
    private final Notices notices;
    private final FileActions files;
    private final EditorModel model;
    private final EditorWindow window;
    private final DiskBar disk;

    /**
     * Opens the window.
     *
     * @param hops      runs tasks in turn on the window's thread
     * @param mostWidth the largest size of the window, pixels: the screen's; likewise {@code mostHeight}
     */
    Editor(Stage stage, OpenDocument document, Executor hops, FilePrompt prompt, double mostWidth, double mostHeight) {
        this.stage = stage;
        preferences.choice("theme", Looks.DARK).wear();
        notices = new Notices(stage);
        model = new EditorModel(document, recovery, hops);
        model.precisionProperty().set(preferences.choice("precision", Precision.EXACT));
        model.viewProperty().set(model.viewProperty().get().withCurve(preferences.choice("curve", DisplayCurve.SRGB)));
        model.previewLook().restore(preferences);
        files = new FileActions(model, prompt, notices, preferences, this::closeWindow);
        window = new EditorWindow(model, files, notices);
        disk = new DiskBar(model, hops, files::compareWithDisk);
        window.addLine(disk);
        model.situationProperty().subscribe(now -> stage.setTitle((now.dirty() ? "• " : "") + model.document().name() + " – Lightning"));
        stage.focusedProperty().subscribe(_ -> disk.look());
        stage.setOnCloseRequest(e -> {
            if (files.mayLeave()) {
                remember();
            } else {
                e.consume();
            }
        });
        preferences.opened(document.file());
        EditorStage.show(stage, window, preferences, mostWidth, mostHeight);
        window.focus();
    }

    EditorModel model() {
        return model;
    }

    public FileActions files() {
        return files;
    }

    /** Asks about edits that a crash left unsaved. */
    void offerRecovery() {
        List<Recovery.Found> all;
        try {
            all = recovery.found();
        } catch (IOException e) {
            return;
        }
        for (Recovery.Found found : all) {
            ButtonType answer = notices.recover(found).orElse(null);
            try {
                if (answer == Notices.RECOVER) {
                    model.recover(found);
                    return;
                }
                if (answer == Notices.FORGET) {
                    found.delete();
                }
            } catch (IOException | JenException e) {
                notices.failed("The edits could not be recovered", e);
            }
        }
    }

    /** Says that a scene could not be opened, and goes on when it was read. */
    void failed(Path file, Exception why) {
        notices.failedAndRead(Quote.path(file) + " could not be opened", why);
    }

    private void closeWindow() {
        stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
    }

    private void remember() {
        preferences.set("width", stage.getScene().getWidth());
        preferences.set("height", stage.getScene().getHeight());
        preferences.set("theme", Looks.worn().name());
        preferences.set("curve", model.viewProperty().get().curve().name());
        model.previewLook().remember(preferences);
        preferences.set("precision", model.precisionProperty().get().name());
        preferences.save();
    }

    @Override
    public void close() {
        disk.close();
        window.close();
        model.close();
    }
}
