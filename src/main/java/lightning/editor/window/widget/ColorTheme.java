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
public enum ColorTheme {
    DARK, LIGHT;

    private static final PseudoClass BRIGHT = PseudoClass.getPseudoClass("bright");
    private static final List<String> STYLE_SHEETS =
            Stream.of("dark.css", "light.css", "window.css", "lightning.css", "mixer.css", "timeline.css").map(ColorTheme::url).toList();
    private static final Theme BASE_THEME = new PrimerDark();
    /** Windows that still wear the other theme. */
    private static final Deque<Window> PENDING_WINDOWS = new ArrayDeque<>();
    private static ColorTheme current = DARK;
    private static boolean isInstalled;

    /** The theme that all rules are of. */
    static Theme baseTheme() {
        return BASE_THEME;
    }

    /** For all windows, those that are open too: the editor's at once, the others one after the other. */
    public void apply() {
        current = this;
        install();
        PENDING_WINDOWS.clear();
        PENDING_WINDOWS.addAll(Window.getWindows());
        if (!PENDING_WINDOWS.isEmpty()) {
            applyTo(PENDING_WINDOWS.remove());
            updatePendingWindows();
        }
    }

    /** One window in each pulse: each takes its time. */
    private static void updatePendingWindows() {
        new AnimationTimer() {
            @Override
            public void handle(long now) {
                if (PENDING_WINDOWS.isEmpty()) {
                    stop();
                } else {
                    applyTo(PENDING_WINDOWS.remove());
                }
            }
        }.start();
    }

    private static void install() {
        if (!isInstalled) {
            isInstalled = true;
            // Compiled: parsing it takes a tenth of a second at each start.
            Application.setUserAgentStylesheet(BASE_THEME.getUserAgentStylesheetBSS());
            // Menus and tooltips are windows too, which nobody else gives the theme.
            Window.getWindows().addListener((ListChangeListener<Window>) change -> {
                while (change.next()) {
                    change.getAddedSubList().forEach(ColorTheme::applyTo);
                }
            });
        }
    }

    public static ColorTheme current() {
        return current;
    }

    /** A scene that wears the theme, put on before it has content, which is quickest. Sizes in pixels. */
    public static Scene scene(Parent content, double width, double height) {
        return withContent(new Scene(new Group(), width, height), content);
    }

    /** The same, as large as its content wants to be. */
    public static Scene scene(Parent content) {
        return withContent(new Scene(new Group()), content);
    }

    private static Scene withContent(Scene scene, Parent content) {
        style(scene);
        scene.setRoot(content);
        return scene;
    }

    /** Gives a scene the style sheets, unless it has them, and the theme. */
    public static void style(Scene scene) {
        if (!scene.getStylesheets().equals(STYLE_SHEETS)) {
            scene.getStylesheets().setAll(STYLE_SHEETS);
            scene.rootProperty().subscribe(ColorTheme::applyTo);
        }
        applyTo(scene.getRoot());
    }

    private static void applyTo(Window window) {
        if (window.getScene() != null) {
            applyTo(window.getScene().getRoot());
        }
    }

    /** Gives the theme to what is styled as the root of a window. */
    public static void applyTo(Parent root) {
        if (root != null) {
            root.pseudoClassStateChanged(BRIGHT, current == LIGHT);
        }
    }

    private static String url(String sheet) {
        return ColorTheme.class.getResource(sheet).toExternalForm();
    }
}
