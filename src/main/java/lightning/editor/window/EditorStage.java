package lightning.editor.window;

import javafx.scene.Group;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.image.Image;
import javafx.stage.Stage;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.WindowPlacement;

/** Main window of the editor: restores its last size, limited to the screen. */
final class EditorStage {
    private static final double DEFAULT_WIDTH = 1600;
    private static final double DEFAULT_HEIGHT = 950;
    /** Minimum size that fits two pictures and the properties, pixels. */
    private static final double MIN_WIDTH = 860;
    private static final double MIN_HEIGHT = 480;
    /** Limits of a stored window size, pixels. Values outside are invalid preferences. */
    private static final double MIN_SIDE = 200;
    private static final double MAX_SIDE = 32_768;

    private EditorStage() {}

    /**
     * Opens the window with content that needs no style sheet.
     *
     * @param maxWidth maximum width of the window: that of the screen, pixels
     * @param maxHeight maximum height of the window, pixels
     */
    static void showUnstyled(Stage stage, Parent content, Preferences preferences, double maxWidth, double maxHeight) {
        fit(stage, content, preferences, maxWidth, maxHeight);
        stage.show();
    }

    /** Shows content in the window and opens the window if necessary. Sizes as in {@link #showUnstyled}. */
    static void show(Stage stage, Parent content, Preferences preferences, double maxWidth, double maxHeight) {
        if (stage.getScene() == null) {
            fit(stage, new Group(), preferences, maxWidth, maxHeight);
        }
        // Styling an empty scene is fastest.
        ColorTheme.style(stage.getScene());
        if (stage.getScene().getRoot() != content) {
            stage.getScene().setRoot(content);
        }
        stage.show();
    }

    private static void fit(Stage stage, Parent content, Preferences preferences, double maxWidth, double maxHeight) {
        stage.setScene(new Scene(content, Math.min(maxWidth, preferences.number("width", MIN_SIDE, MAX_SIDE, DEFAULT_WIDTH)),
                Math.min(maxHeight, preferences.number("height", MIN_SIDE, MAX_SIDE, DEFAULT_HEIGHT))));
        stage.getIcons().add(new Image(String.valueOf(EditorStage.class.getResource("icon.png")), true));
        stage.setMinWidth(Math.min(maxWidth, MIN_WIDTH));
        stage.setMinHeight(Math.min(maxHeight, MIN_HEIGHT));
        WindowPlacement.fitOnShow(stage);
    }
}
