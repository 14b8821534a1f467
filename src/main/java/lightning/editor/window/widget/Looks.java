package lightning.editor.window.widget;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.Theme;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import javafx.animation.AnimationTimer;
import javafx.application.Application;
import javafx.collections.ListChangeListener;
import javafx.css.PseudoClass;
import javafx.scene.Group;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.stage.Window;

/**
 * The theme: calm and dark, so that the pictures stand out, or light for bright rooms. Belongs to the window's thread.
 *
 * <p>Both have the same style sheets, and the light one is a state of each window's root: no rule is matched anew where another theme is put
 * on, which would take most of its time.
 */
public enum Looks {
    DARK, LIGHT;

    private static final PseudoClass BRIGHT = PseudoClass.getPseudoClass("bright");
    private static final List<String> SHEETS =
            Stream.of("dark.css", "light.css", "window.css", "lightning.css", "mixer.css", "timeline.css").map(Looks::url).toList();
    private static final Theme THEME = new PrimerDark();
    /** Windows that still wear the other theme. */
    private static final Deque<Window> WAITING = new ArrayDeque<>();
    private static Looks worn = DARK;
    private static boolean begun;

    /** The theme that all rules are of. */
    static Theme theme() {
        return THEME;
    }

    /** For all windows, those that are open too: the editor's at once, the others one after the other. */
    public void wear() {
        worn = this;
        begin();
        WAITING.clear();
        WAITING.addAll(Window.getWindows());
        if (!WAITING.isEmpty()) {
            color(WAITING.remove());
            goOn();
        }
    }

    /** One window in each pulse: each takes its time. */
    private static void goOn() {
        new AnimationTimer() {
            @Override
            public void handle(long now) {
                if (WAITING.isEmpty()) {
                    stop();
                } else {
                    color(WAITING.remove());
                }
            }
        }.start();
    }

    private static void begin() {
        if (!begun) {
            begun = true;
            // Compiled: parsing it takes a tenth of a second at each start.
            Application.setUserAgentStylesheet(THEME.getUserAgentStylesheetBSS());
            // Menus and tooltips are windows too, which nobody else gives the theme.
            Window.getWindows().addListener((ListChangeListener<Window>) change -> {
                while (change.next()) {
                    change.getAddedSubList().forEach(Looks::color);
                }
            });
        }
    }

    public static Looks worn() {
        return worn;
    }

    /** A scene that wears the theme, put on before it has content, which is quickest. Sizes in pixels. */
    public static Scene scene(Parent content, double width, double height) {
        return filled(new Scene(new Group(), width, height), content);
    }

    /** The same, as large as its content wants to be. */
    public static Scene scene(Parent content) {
        return filled(new Scene(new Group()), content);
    }

    private static Scene filled(Scene scene, Parent content) {
        dress(scene);
        scene.setRoot(content);
        return scene;
    }

    /** Gives a scene the style sheets, unless it has them, and the theme. */
    public static void dress(Scene scene) {
        if (!scene.getStylesheets().equals(SHEETS)) {
            scene.getStylesheets().setAll(SHEETS);
            scene.rootProperty().subscribe(Looks::color);
        }
        color(scene.getRoot());
    }

    private static void color(Window window) {
        if (window.getScene() != null) {
            color(window.getScene().getRoot());
        }
    }

    /** Gives the theme to what is styled as the root of a window. */
    public static void color(Parent root) {
        if (root != null) {
            root.pseudoClassStateChanged(BRIGHT, worn == LIGHT);
        }
    }

    private static String url(String sheet) {
        return Looks.class.getResource(sheet).toExternalForm();
    }
}
