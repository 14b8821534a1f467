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
import org.jspecify.annotations.Nullable;

/**
 * Color theme of all windows, dark or light. Belongs to the window's thread.
 *
 * <p>Both themes share the style sheets; the light one is a pseudo-class of each window's root. Switching therefore matches no CSS rules
 * again, which would take most of its time.
 */
public enum ColorTheme {
    DARK, LIGHT;

    private static final PseudoClass BRIGHT = PseudoClass.getPseudoClass("bright");
    private static final List<String> STYLE_SHEETS =
            Stream.of("dark.css", "light.css", "window.css", "lightning.css", "mixer.css", "timeline.css").map(ColorTheme::url).toList();
    private static final Theme BASE_THEME = new PrimerDark();
    /** Windows that still show the previous theme. */
    private static final Deque<Window> PENDING_WINDOWS = new ArrayDeque<>();
    private static ColorTheme current = DARK;
    private static boolean isInstalled;

    /** Returns the theme that provides the CSS rules. */
    static Theme baseTheme() {
        return BASE_THEME;
    }

    /** Applies the theme to all windows, including open ones: to the editor's immediately, to the others one by one. */
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

    /** Updates one window per pulse, since each takes time. */
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
            // Precompiled: parsing takes 0.1 s at each start.
            Application.setUserAgentStylesheet(BASE_THEME.getUserAgentStylesheetBSS());
            // Menus and tooltips are windows too.
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

    /** Creates a themed scene. The theme is set before the content, which is fastest. Sizes in pixels. */
    public static Scene scene(Parent content, double width, double height) {
        return withContent(new Scene(new Group(), width, height), content);
    }

    /** Creates a themed scene with the preferred size of its content. */
    public static Scene scene(Parent content) {
        return withContent(new Scene(new Group()), content);
    }

    private static Scene withContent(Scene scene, Parent content) {
        style(scene);
        scene.setRoot(content);
        return scene;
    }

    /** Adds the style sheets to a scene, unless present, and applies the theme. */
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

    /** Applies the theme to a node that is styled as a root. */
    public static void applyTo(@Nullable Parent root) {
        if (root != null) {
            root.pseudoClassStateChanged(BRIGHT, current == LIGHT);
        }
    }

    private static String url(String sheet) {
        return ColorTheme.class.getResource(sheet).toExternalForm();
    }
}
