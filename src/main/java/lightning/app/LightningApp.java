package lightning.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.stage.Screen;
import javafx.stage.Stage;
import lightning.app.command.FilePrompt;
import lightning.app.model.Preferences;
import lightning.app.model.Sentence;
import lightning.app.widget.Looks;
import lightning.edit.OpenDocument;
import lightning.jen.JenException;

/** The editor's program. */
public final class LightningApp extends Application {
    private Editor editor;

    /**
     * Opens the editor and returns when its window is closed. At most once in a process.
     *
     * @param arguments the scene file to open, or nothing
     */
    public static void open(List<String> arguments) {
        launch(LightningApp.class, arguments.toArray(String[]::new));
    }

    @Override
    public void start(Stage stage) {
        List<String> arguments = getParameters() == null ? List.of() : getParameters().getUnnamed();
        Path first = Folders.firstScene();
        Path file = arguments.isEmpty() ? first : Path.of(arguments.getFirst());
        var preferences = new Preferences(Folders.data());
        preferences.choice("theme", Looks.DARK).wear();
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        EditorStage.show(stage, new OpeningPane(file), preferences, screen.getWidth(), screen.getHeight());
        var reading = new Thread(() -> read(stage, file, first), "lightning-open");
        reading.setDaemon(true);
        reading.start();
    }

    /** A large scene takes its time, and the window is there before. */
    private void read(Stage stage, Path file, Path first) {
        try {
            OpenDocument document = OpenDocument.open(file);
            unlessClosed(stage, () -> {
                show(stage, document);
                editor.offerRecovery();
            });
        } catch (IOException | JenException | RuntimeException e) {
            unlessClosed(stage, () -> instead(stage, file, first, e));
        }
    }

    /** Nobody waits for a scene whose window was closed while it was read. */
    private static void unlessClosed(Stage stage, Runnable then) {
        Platform.runLater(() -> {
            if (stage.isShowing()) {
                then.run();
            }
        });
    }

    /** A window on the first scene takes the place of one on a scene that cannot be opened. */
    private void instead(Stage stage, Path file, Path first, Exception why) {
        try {
            show(stage, OpenDocument.open(first));
            editor.failed(file, why);
            editor.offerRecovery();
        } catch (IOException | JenException e) {
            new Alert(Alert.AlertType.ERROR, Sentence.of(why), ButtonType.CLOSE).showAndWait();
            Platform.exit();
        }
    }

    private void show(Stage stage, OpenDocument document) {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        editor = new Editor(stage, document, Platform::runLater, FilePrompt.of(stage), screen.getWidth(), screen.getHeight());
    }

    @Override
    public void stop() {
        if (editor != null) {
            editor.close();
        }
    }
}
