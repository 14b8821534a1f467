package lightning.editor.window.widget;

import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.util.Duration;

/**
 * Lets a remark be seen only where there is something to remark on for longer than a person notices: what comes and goes
 * with each update of a drag would flash. Belongs to the window's thread.
 */
public final class Lasting {
    /** What is over sooner goes unnoticed. */
    public static final Duration NOTICED = Duration.millis(100);

    /** Runs tasks later, on the window's thread. */
    public interface Later {
        /** The window's own time. */
        Later WINDOW = (delay, task) -> {
            var pause = new PauseTransition(delay);
            pause.setOnFinished(_ -> task.run());
            pause.play();
            return pause::stop;
        };

        /** @return calls it off */
        Runnable in(Duration delay, Runnable task);
    }

    private final Later later;
    private final Duration patience;
    private final Consumer<String> shown;
    private String wanted = "";
    private boolean visible;
    /** Null where nothing is waited for. */
    private Runnable callOff;

    /**
     * @param patience how long a remark must last before it is shown
     * @param shown    hears what is to be seen now; empty for nothing
     */
    public Lasting(Later later, Duration patience, Consumer<String> shown) {
        this.later = later;
        this.patience = patience;
        this.shown = shown;
        shown.accept("");
    }

    /** What is to be remarked on now; empty for nothing. Other words for what is seen already are seen at once. */
    public void tell(String remark) {
        if (remark.equals(wanted)) {
            return;
        }
        wanted = remark;
        if (remark.isEmpty()) {
            forget();
        } else if (visible) {
            shown.accept(remark);
        } else if (callOff == null) {
            callOff = later.in(patience, this::show);
        }
    }

    /** The same, seen at once. */
    public void tellAtOnce(String remark) {
        tell(remark);
        if (callOff != null) {
            callOff.run();
            show();
        }
    }

    private void show() {
        callOff = null;
        visible = true;
        shown.accept(wanted);
    }

    private void forget() {
        if (callOff != null) {
            callOff.run();
            callOff = null;
        }
        if (visible) {
            visible = false;
            shown.accept("");
        }
    }
}
