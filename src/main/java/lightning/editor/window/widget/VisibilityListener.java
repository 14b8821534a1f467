package lightning.editor.window.widget;

import java.util.function.Supplier;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javafx.util.Subscription;
import org.jspecify.annotations.Nullable;

/**
 * Runs a pane's subscriptions only while its window is open, so that a hidden pane costs nothing.
 *
 * <p>Handles window events rather than the showing property, since JavaFX notifies listeners incorrectly if some are removed meanwhile.
 */
public final class VisibilityListener {
    private final Supplier<Subscription> starter;
    private final EventHandler<WindowEvent> showingHandler = _ -> start();
    private final EventHandler<WindowEvent> hiddenHandler = _ -> stop();
    private Subscription subscription = Subscription.EMPTY;
    private @Nullable Window window;

    private VisibilityListener(Supplier<Subscription> starter) {
        this.starter = starter;
    }

    /**
     * Attaches subscriptions to a pane's window.
     *
     * @param starter  called each time the window opens. Its subscription ends when the window closes or the pane leaves it, and must stop
     *     all threads that it started.
     */
    public static void attach(Node pane, Supplier<Subscription> starter) {
        pane.sceneProperty().flatMap(Scene::windowProperty).subscribe(new VisibilityListener(starter)::setWindow);
    }

    /** @param newWindow  window of the pane; null for none */
    private void setWindow(@Nullable Window newWindow) {
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
