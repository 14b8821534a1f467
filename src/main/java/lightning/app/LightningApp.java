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
        Looks.DARK.wear();
        List<String> arguments = getParameters() == null ? List.of() : getParameters().getUnnamed();
        Path first = Folders.firstScene();
        Path file = arguments.isEmpty() ? first : Path.of(arguments.getFirst());
        try {
            show(stage, OpenDocument.open(file));
            Platform.runLater(editor::offerRecovery);
        } catch (IOException | JenException e) {
            instead(stage, file, first, e);
        }
    }

    /** A window on the first scene takes the place of one on a scene that cannot be opened. */
    private void instead(Stage stage, Path file, Path first, Exception why) {
        try {
            show(stage, OpenDocument.open(first));
            Platform.runLater(() -> {
                editor.failed(file, why);
                editor.offerRecovery();
            });
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
