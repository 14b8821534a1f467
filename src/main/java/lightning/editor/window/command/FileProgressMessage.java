package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.editor.window.model.FileActivity;
import lightning.editor.window.model.StatusMessage;

/** Tells in the status line how much of a file is read or written; stops that when nobody waits for it any more. Any thread may call. */
final class FileProgressMessage implements Progress {
    private final FileActivity activity;
    private final Executor window;
    private final StatusMessage message;
    private final Path file;
    private final AtomicInteger lastPercent = new AtomicInteger(-1);

    /** @param window runs tasks in turn on the window's thread */
    FileProgressMessage(Path file, FileActivity activity, Executor window, StatusMessage message) {
        this.activity = activity;
        this.window = window;
        this.message = message;
        this.file = file;
    }

    @Override
    public void report(int done, int total) {
        int percent = total == 0 ? 100 : (int) (100L * done / total);
        if (lastPercent.getAndSet(percent) != percent) {
            window.execute(() -> {
                if (activity.isActive(file)) {
                    message.show(activity.title() + " " + Quote.path(file.getFileName()) + ": " + percent + " %");
                }
            });
        }
    }

    @Override
    public boolean isCanceled() {
        return !activity.isActive(file);
    }
}
