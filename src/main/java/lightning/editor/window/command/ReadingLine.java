package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.editor.window.model.FileWork;
import lightning.editor.window.model.StatusMessage;

/** Tells in the status line how much of a file is read or written; stops that when nobody waits for it any more. Any thread may call. */
final class ReadingLine implements Progress {
    private final FileWork work;
    private final Executor window;
    private final StatusMessage message;
    private final Path file;
    private final AtomicInteger told = new AtomicInteger(-1);

    /** @param window runs tasks in turn on the window's thread */
    ReadingLine(Path file, FileWork work, Executor window, StatusMessage message) {
        this.work = work;
        this.window = window;
        this.message = message;
        this.file = file;
    }

    @Override
    public void tiles(int done, int total) {
        int percent = total == 0 ? 100 : (int) (100L * done / total);
        if (told.getAndSet(percent) != percent) {
            window.execute(() -> {
                if (work.isWanted(file)) {
                    message.show(work.title() + " " + Quote.path(file.getFileName()) + ": " + percent + " %");
                }
            });
        }
    }

    @Override
    public boolean isCancelled() {
        return !work.isWanted(file);
    }
}
