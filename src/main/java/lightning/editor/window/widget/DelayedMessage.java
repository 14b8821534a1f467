package lightning.editor.window.widget;

import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.util.Duration;
import org.jspecify.annotations.Nullable;

/**
 * Shows a status message only after it has applied for a minimum time, so that it does not flash during a drag. Belongs to the window's
 * thread.
 */
public final class DelayedMessage {
    /** Default minimum time. Shorter conditions go unnoticed. */
    public static final Duration MIN_DURATION = Duration.millis(100);

    /** Schedules tasks on the window's thread. */
    public interface Scheduler {
        /** Scheduler of the JavaFX thread. */
        Scheduler FX_THREAD = (delay, task) -> {
            var pause = new PauseTransition(delay);
            pause.setOnFinished(_ -> task.run());
            pause.play();
            return pause::stop;
        };

        /** @return cancels the task */
        Runnable schedule(Duration delay, Runnable task);
    }

    private final Scheduler scheduler;
    private final Duration delay;
    private final Consumer<String> display;
    private String message = "";
    private boolean visible;
    /** Cancels the pending task; null if there is none. */
    private @Nullable Runnable cancelPending;

    /**
     * @param delay  time before a message is shown
     * @param display  receives the visible message; empty for none
     */
    public DelayedMessage(Scheduler scheduler, Duration delay, Consumer<String> display) {
        this.scheduler = scheduler;
        this.delay = delay;
        this.display = display;
        display.accept("");
    }

    /** Sets the message; empty for none. A message that is already visible changes immediately. */
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

    /** Sets the message and shows it immediately. */
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
