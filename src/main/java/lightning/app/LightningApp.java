package lightning.app;

import atlantafx.base.theme.PrimerDark;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.scene.Scene;
import javafx.stage.Stage;
import lightning.edit.Autosave;
import lightning.edit.OpenDocument;
import lightning.edit.Recovery;
import lightning.jen.JenException;

/** The editor's program. */
public final class LightningApp extends Application {
    private static final double WIDTH = 1000;
    private static final double HEIGHT = 700;

    private EditorModel model;

    /**
     * Opens the editor and returns when its window is closed. At most once in a process.
     *
     * @param arguments the scene file to open, or nothing
     */
    public static void open(List<String> arguments) {
        launch(LightningApp.class, arguments.toArray(String[]::new));
    }

    @Override
    public void start(Stage stage) throws IOException, JenException {
        setUserAgentStylesheet(new PrimerDark().getUserAgentStylesheet());
        List<String> arguments = getParameters() == null ? List.of() : getParameters().getUnnamed();
        Path file = arguments.isEmpty() ? Folders.firstScene() : Path.of(arguments.getFirst());
        Autosave autosave = new Autosave(new Recovery(Folders.data().resolve("recovery")), Autosave.DEFAULT_DELAY,
                e -> Platform.runLater(() -> model.say("The last edits could not be kept for the case of a crash.")));
        model = new EditorModel(OpenDocument.open(file), Platform::runLater, autosave);
        stage.setTitle("Lightning");
        stage.setScene(new Scene(new EditorWindow(model), WIDTH, HEIGHT));
        stage.show();
    }

    @Override
    public void stop() {
        model.close();
    }
}
