package lightning.editor.window.widget;

import java.util.ArrayList;
import java.util.List;
import javafx.util.Duration;

/** Scheduler with a manually advanced clock. */
public final class ManualScheduler implements DelayedMessage.Scheduler {
    private record Task(Duration at, Runnable work) {}

    private final List<Task> tasks = new ArrayList<>();
    private Duration now = Duration.ZERO;

    @Override
    public Runnable schedule(Duration delay, Runnable work) {
        var task = new Task(now.add(delay), work);
        tasks.add(task);
        return () -> tasks.remove(task);
    }

    /** Runs due tasks in the order in which they were scheduled. */
    public void advance(Duration time) {
        now = now.add(time);
        for (Task task : List.copyOf(tasks)) {
            if (task.at().lessThanOrEqualTo(now) && tasks.remove(task)) {
                task.work().run();
            }
        }
    }
}
