package lightning.app;

import atlantafx.base.theme.PrimerDark;
import java.util.List;
import javafx.application.Application;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;

/** The editor's window. */
public final class LightningApp extends Application {
    /** The whole screen of the platform without a window system, which a larger window would leave. */
    private static final double WIDTH = 1000;
    private static final double HEIGHT = 700;

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
        setUserAgentStylesheet(new PrimerDark().getUserAgentStylesheet());
        Label greeting = new Label("Lightning");
        greeting.setId("greeting");
        stage.setTitle("Lightning");
        stage.setScene(new Scene(new StackPane(greeting), WIDTH, HEIGHT));
        stage.show();
    }
}
