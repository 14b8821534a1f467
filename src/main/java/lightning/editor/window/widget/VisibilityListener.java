package lightning.editor.window.widget;

import java.util.function.Supplier;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javafx.util.Subscription;

/**
 * What a pane does while its window is open: one that nobody sees costs nothing. It hears the window's events and not its property,
 * whose listeners the window toolkit confuses where some of them leave while they are told.
 */
public final class VisibilityListener {
    private final Supplier<Subscription> starter;
    private final EventHandler<WindowEvent> showingHandler = _ -> start();
    private final EventHandler<WindowEvent> hiddenHandler = _ -> stop();
    private Subscription subscription = Subscription.EMPTY;
    private Window window;

    private VisibilityListener(Supplier<Subscription> starter) {
        this.starter = starter;
    }

    /**
     * Begins and ends with the pane's window.
     *
     * @param starter called whenever the window opens; ended when that closes, or when the pane leaves it, and must then end all threads
     *              that it started
     */
    public static void attach(Node pane, Supplier<Subscription> starter) {
        pane.sceneProperty().flatMap(Scene::windowProperty).subscribe(new VisibilityListener(starter)::setWindow);
    }

    /** @param newWindow null where the pane is in no window */
    private void setWindow(Window newWindow) {
        if (window != null) {
            window.removeEventHandler(WindowEvent.WINDOW_SHOWING, showingHandler);
            window.removeEventHandler(WindowEvent.WINDOW_HIDDEN, hiddenHandler);
        }
        stop();
        window = newWindow;
        if (newWindow != null) {
            newWindow.addEventHandler(WindowEvent.WINDOW_SHOWING, showingHandler);
            newWindow.addEventHandler(WindowEvent.WINDOW_HIDDEN, hiddenHandler);
            if (newWindow.isShowing()) {
                start();
            }
        }
    }

    private void start() {
        stop();
        subscription = starter.get();
    }

    private void stop() {
        subscription.unsubscribe();
        subscription = Subscription.EMPTY;
    }
}
