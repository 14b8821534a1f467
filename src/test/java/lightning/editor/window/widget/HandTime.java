package lightning.editor.window.widget;

import java.util.ArrayList;
import java.util.List;
import javafx.util.Duration;

/** Time that passes by hand. */
public final class HandTime implements Lasting.Later {
    private record Task(Duration at, Runnable work) {}

    private final List<Task> waiting = new ArrayList<>();
    private Duration now = Duration.ZERO;

    @Override
    public Runnable in(Duration delay, Runnable work) {
        var task = new Task(now.add(delay), work);
        waiting.add(task);
        return () -> waiting.remove(task);
    }

    /** Runs what is due, in the order in which it was asked for. */
    public void pass(Duration time) {
        now = now.add(time);
        for (Task task : List.copyOf(waiting)) {
            if (task.at().lessThanOrEqualTo(now) && waiting.remove(task)) {
                task.work().run();
            }
        }
    }
}
