package lightning.app.widget;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;
import atlantafx.base.theme.Theme;
import java.util.ArrayList;
import java.util.List;
import javafx.application.Application;
import javafx.scene.Scene;
import javafx.stage.Window;

/** The theme: calm and dark, so that the pictures stand out, or light for bright rooms. Belongs to the window's thread. */
public enum Looks {
    DARK, LIGHT;

    private static final List<String> SHEETS = List.of("window.css", "lightning.css", "mixer.css", "timeline.css");
    private static Looks worn = DARK;

    Theme theme() {
        return switch (this) {
            case DARK -> new PrimerDark();
            case LIGHT -> new PrimerLight();
        };
    }

    /** For all windows, those that are open too. */
    public void wear() {
        worn = this;
        // Compiled: parsing it takes a tenth of a second at each start.
        Application.setUserAgentStylesheet(theme().getUserAgentStylesheetBSS());
        Window.getWindows().stream().map(Window::getScene).filter(s -> s != null && s.getStylesheets().contains(url(SHEETS.getFirst())))
                .forEach(Looks::dress);
    }

    public static Looks worn() {
        return worn;
    }

    /** What the theme lacks. */
    public static void dress(Scene scene) {
        List<String> sheets = new ArrayList<>();
        sheets.add(url(switch (worn) {
            case DARK -> "dark.css";
            case LIGHT -> "light.css";
        }));
        SHEETS.forEach(sheet -> sheets.add(url(sheet)));
        scene.getStylesheets().setAll(sheets);
    }

    private static String url(String sheet) {
        return Looks.class.getResource(sheet).toExternalForm();
    }
}
