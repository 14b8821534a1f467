package lightning.editor.window.widget;

import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.stage.Screen;
import javafx.stage.Window;
import javafx.stage.WindowEvent;

/** Keeps windows within the screen. */
public final class WindowPlacement {
    private WindowPlacement() {}

    /** Moves and shrinks a window to fit the screen when it opens. */
    public static void fitOnShow(Window window) {
        window.addEventHandler(WindowEvent.WINDOW_SHOWN, _ -> {
            fit(window);
            // The window's decoration size is known only later.
            Platform.runLater(() -> fit(window));
        });
    }

    /** Moves a window into the screen and shrinks it if necessary. */
    public static void fit(Window window) {
        if (!window.isShowing() || !(window.getWidth() > 0) || Double.isNaN(window.getX()) || Double.isNaN(window.getY())) {
            return;
        }
        Rectangle2D screen = screenBounds(window);
        Rectangle2D bounds = new Rectangle2D(window.getX(), window.getY(), window.getWidth(), window.getHeight());
        Rectangle2D target = clampTo(screen, bounds);
        if (!target.equals(bounds)) {
            window.setX(target.getMinX());
            window.setY(target.getMinY());
            window.setWidth(target.getWidth());
            window.setHeight(target.getHeight());
        }
    }

    /** Returns the usable bounds of the window's screen. */
    public static Rectangle2D screenBounds(Window window) {
        return Screen.getScreensForRectangle(window.getX(), window.getY(), 1, 1).stream().findFirst()
                .orElseGet(Screen::getPrimary).getVisualBounds();
    }

    /** Returns the nearest bounds of a window within a screen, shrunk if necessary. */
    public static Rectangle2D clampTo(Rectangle2D screen, Rectangle2D window) {
        double width = Math.min(window.getWidth(), screen.getWidth());
        double height = Math.min(window.getHeight(), screen.getHeight());
        return new Rectangle2D(Math.clamp(window.getMinX(), screen.getMinX(), screen.getMaxX() - width),
                Math.clamp(window.getMinY(), screen.getMinY(), screen.getMaxY() - height), width, height);
    }
}
