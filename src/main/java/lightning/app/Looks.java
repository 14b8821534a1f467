package lightning.app;

import atlantafx.base.theme.PrimerDark;
import java.util.List;
import javafx.application.Application;
import javafx.scene.Scene;

/** The theme: calm and dark, so that the pictures stand out. */
final class Looks {
    private Looks() {}

    /** For all windows. */
    static void install() {
        Application.setUserAgentStylesheet(new PrimerDark().getUserAgentStylesheet());
    }

    /** What the theme lacks. */
    static void dress(Scene scene) {
        for (String sheet : List.of("dark.css", "window.css", "lightning.css")) {
            scene.getStylesheets().add(Looks.class.getResource(sheet).toExternalForm());
        }
    }
}
