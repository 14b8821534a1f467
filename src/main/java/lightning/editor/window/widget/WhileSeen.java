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
public final class WhileSeen {
    private final Supplier<Subscription> begin;
    private final EventHandler<WindowEvent> showing = _ -> begin();
    private final EventHandler<WindowEvent> hidden = _ -> end();
    private Subscription begun = Subscription.EMPTY;
    private Window window;

    private WhileSeen(Supplier<Subscription> begin) {
        this.begin = begin;
    }

    /**
     * Begins and ends with the pane's window.
     *
     * @param begin called whenever the window opens; ended when that closes, or when the pane leaves it, and must then end all threads
     *              that it started
     */
    public static void follow(Node pane, Supplier<Subscription> begin) {
        pane.sceneProperty().flatMap(Scene::windowProperty).subscribe(new WhileSeen(begin)::enter);
    }

    /** @param now null where the pane is in no window */
    private void enter(Window now) {
        if (window != null) {
            window.removeEventHandler(WindowEvent.WINDOW_SHOWING, showing);
            window.removeEventHandler(WindowEvent.WINDOW_HIDDEN, hidden);
        }
        end();
        window = now;
        if (now != null) {
            now.addEventHandler(WindowEvent.WINDOW_SHOWING, showing);
            now.addEventHandler(WindowEvent.WINDOW_HIDDEN, hidden);
            if (now.isShowing()) {
                begin();
            }
        }
    }

    private void begin() {
        end();
        begun = begin.get();
    }

    private void end() {
        begun.unsubscribe();
        begun = Subscription.EMPTY;
    }
}
