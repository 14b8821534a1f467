package lightning.editor.window;

import javafx.scene.Group;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.image.Image;
import javafx.stage.Stage;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.widget.Looks;
import lightning.editor.window.widget.OnScreen;

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
     * Opens the window with something in it that needs no style sheet.
     *
     * @param mostWidth the largest size of the window, pixels: the screen's; likewise {@code mostHeight}
     */
    static void begin(Stage stage, Parent content, Preferences preferences, double mostWidth, double mostHeight) {
        fit(stage, content, preferences, mostWidth, mostHeight);
        stage.show();
    }

    /** Opens the window with something in it, or shows that where it is open. Sizes as before. */
    static void show(Stage stage, Parent content, Preferences preferences, double mostWidth, double mostHeight) {
        if (stage.getScene() == null) {
            fit(stage, new Group(), preferences, mostWidth, mostHeight);
        }
        // Before there is content, which is quickest.
        Looks.dress(stage.getScene());
        if (stage.getScene().getRoot() != content) {
            stage.getScene().setRoot(content);
        }
        stage.show();
    }

    private static void fit(Stage stage, Parent content, Preferences preferences, double mostWidth, double mostHeight) {
        stage.setScene(new Scene(content, Math.min(mostWidth, preferences.number("width", LEAST_SIDE, MOST_SIDE, WIDTH)),
                Math.min(mostHeight, preferences.number("height", LEAST_SIDE, MOST_SIDE, HEIGHT))));
        stage.getIcons().add(new Image(String.valueOf(EditorStage.class.getResource("icon.png")), true));
        stage.setMinWidth(Math.min(mostWidth, LEAST_WIDTH));
        stage.setMinHeight(Math.min(mostHeight, LEAST_HEIGHT));
        OnScreen.open(stage);
    }
}
