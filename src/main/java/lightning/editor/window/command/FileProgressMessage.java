package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.editor.window.model.FileActivity;
import lightning.editor.window.model.RemainingTime;
import lightning.editor.window.model.StatusMessage;

/** Shows the progress of reading or writing a file in the status line, and cancels the work with its activity. Thread-safe. */
final class FileProgressMessage implements Progress {
    private final FileActivity activity;
    private final Executor window;
    private final StatusMessage message;
    private final Path file;
    private final AtomicInteger lastPercent = new AtomicInteger(-1);
    /** Used on the window's thread. */
    private final RemainingTime remaining = new RemainingTime();

    /** @param window  runs tasks in order on the window's thread */
    FileProgressMessage(Path file, FileActivity activity, Executor window, StatusMessage message) {
        this.activity = activity;
        this.window = window;
        this.message = message;
        this.file = file;
    }

    /** Returns the progress of the activity's next step, which gets a title of its own, for example "Previewing". */
    FileProgressMessage next(String title) {
        window.execute(() -> activity.setTitle(file, title));
        return new FileProgressMessage(file, activity, window, message);
    }

    @Override
    public void report(int done, int total) {
        int percent = total == 0 ? 100 : (int) (100L * done / total);
        if (lastPercent.getAndSet(percent) != percent) {
            window.execute(() -> {
                if (activity.isActive(file)) {
                    String task = activity.titleProperty().get() + " " + Quote.path(file.getFileName());
                    message.show(remaining.describe(task, percent / 100.0, System.nanoTime()).replace(task, task + ": " + percent + " %"));
                }
            });
        }
    }

    @Override
    public boolean isCanceled() {
        return !activity.isActive(file);
    }
}
