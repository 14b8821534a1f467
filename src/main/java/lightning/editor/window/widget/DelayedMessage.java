package lightning.editor.window.widget;

import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.util.Duration;

/**
 * Lets a remark be seen only where there is something to remark on for longer than a person notices: what comes and goes
 * with each update of a drag would flash. Belongs to the window's thread.
 */
public final class DelayedMessage {
    /** What is over sooner goes unnoticed. */
    public static final Duration MIN_DURATION = Duration.millis(100);

    /** Runs tasks later, on the window's thread. */
    public interface Scheduler {
        /** The window's own time. */
        Scheduler FX_THREAD = (delay, task) -> {
            var pause = new PauseTransition(delay);
            pause.setOnFinished(_ -> task.run());
            pause.play();
            return pause::stop;
        };

        /** @return calls it off */
        Runnable schedule(Duration delay, Runnable task);
    }

    private final Scheduler scheduler;
    private final Duration delay;
    private final Consumer<String> display;
    private String message = "";
    private boolean visible;
    /** Null where nothing is waited for. */
    private Runnable cancelPending;

    /**
     * @param delay how long a remark must last before it is shown
     * @param display    hears what is to be seen now; empty for nothing
     */
    public DelayedMessage(Scheduler scheduler, Duration delay, Consumer<String> display) {
        this.scheduler = scheduler;
        this.delay = delay;
        this.display = display;
        display.accept("");
    }

    /** What is to be remarked on now; empty for nothing. Other words for what is seen already are seen at once. */
    public void set(String newMessage) {
        if (newMessage.equals(message)) {
            return;
        }
        message = newMessage;
        if (newMessage.isEmpty()) {
            hide();
        } else if (visible) {
            display.accept(newMessage);
        } else if (cancelPending == null) {
            cancelPending = scheduler.schedule(delay, this::show);
        }
    }

    /** The same, seen at once. */
    public void setImmediately(String newMessage) {
        set(newMessage);
        if (cancelPending != null) {
            cancelPending.run();
            show();
        }
    }

    private void show() {
        cancelPending = null;
        visible = true;
        display.accept(message);
    }

    private void hide() {
        if (cancelPending != null) {
            cancelPending.run();
            cancelPending = null;
        }
        if (visible) {
            visible = false;
            display.accept("");
        }
    }
}
