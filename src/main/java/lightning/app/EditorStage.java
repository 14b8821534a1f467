package lightning.app;

import javafx.scene.Parent;
import javafx.scene.image.Image;
import javafx.stage.Stage;
import lightning.app.model.Preferences;
import lightning.app.widget.Looks;
import lightning.app.widget.OnScreen;

/** The editor's window on the screen: as large as it was left, and wholly seen. */
final class EditorStage {
    private static final double WIDTH = 1600;
    private static final double HEIGHT = 950;
    /** Below these there is no room for two pictures and the properties, pixels. */
    private static final double LEAST_WIDTH = 860;
    private static final double LEAST_HEIGHT = 480;
    /** What a window may have had: less cannot be taken hold of, more no screen has. */
    private static final double LEAST_SIDE = 200;
    private static final double MOST_SIDE = 32_768;

    private EditorStage() {}

    /**
     * Opens the window, or shows something else in it where it is open.
     *
     * @param mostWidth the largest size of the window, pixels: the screen's; likewise {@code mostHeight}
     */
    static void show(Stage stage, Parent content, Preferences preferences, double mostWidth, double mostHeight) {
        if (stage.getScene() == null) {
            stage.setScene(Looks.scene(content, Math.min(mostWidth, preferences.number("width", LEAST_SIDE, MOST_SIDE, WIDTH)),
                    Math.min(mostHeight, preferences.number("height", LEAST_SIDE, MOST_SIDE, HEIGHT))));
            stage.getIcons().add(new Image(String.valueOf(EditorStage.class.getResource("icon.png")), true));
            stage.setMinWidth(Math.min(mostWidth, LEAST_WIDTH));
            stage.setMinHeight(Math.min(mostHeight, LEAST_HEIGHT));
            OnScreen.open(stage);
        } else if (stage.getScene().getRoot() != content) {
            stage.getScene().setRoot(content);
        }
        stage.show();
    }
}
