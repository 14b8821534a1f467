package lightning.editor.window.widget;

import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.stage.Screen;
import javafx.stage.Window;
import javafx.stage.WindowEvent;

/** Keeps windows wholly on the screen where they open. */
public final class WindowPlacement {
    private WindowPlacement() {}

    /** A window opens where all of it is seen, and no larger than the screen. */
    public static void fitOnShow(Window window) {
        window.addEventHandler(WindowEvent.WINDOW_SHOWN, _ -> {
            fit(window);
            // Its frame is known a moment later.
            Platform.runLater(() -> fit(window));
        });
    }

    /** Moves a window, and makes it smaller where it must be. */
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

    /** What windows may take of the screen where this one begins. */
    public static Rectangle2D screenBounds(Window window) {
        return Screen.getScreensForRectangle(window.getX(), window.getY(), 1, 1).stream().findFirst()
                .orElseGet(Screen::getPrimary).getVisualBounds();
    }

    /** The nearest place of a window wholly on a screen; smaller where the screen is. */
    public static Rectangle2D clampTo(Rectangle2D screen, Rectangle2D window) {
        double width = Math.min(window.getWidth(), screen.getWidth());
        double height = Math.min(window.getHeight(), screen.getHeight());
        return new Rectangle2D(Math.clamp(window.getMinX(), screen.getMinX(), screen.getMaxX() - width),
                Math.clamp(window.getMinY(), screen.getMinY(), screen.getMaxY() - height), width, height);
    }
}
