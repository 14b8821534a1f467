package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.base.work.Progress;
import lightning.editor.window.model.EditorModel;

/** Tells in the status line how much of a file is read or written; stops that when nobody waits for it any more. Any thread may call. */
final class ReadingLine implements Progress {
    private final EditorModel model;
    private final Path file;
    private final String what;
    private final AtomicInteger told = new AtomicInteger(-1);

    ReadingLine(EditorModel model, Path file) {
        this(model, file, Texts.of("Reading"));
    }

    /** @param what is done with it */
    ReadingLine(EditorModel model, Path file, String what) {
        this.model = model;
        this.file = file;
        this.what = what;
    }

    @Override
    public void tiles(int done, int total) {
        int percent = total == 0 ? 100 : (int) (100L * done / total);
        if (told.getAndSet(percent) != percent) {
            model.files().window().execute(() -> {
                if (model.fileWork().isWanted(file)) {
                    model.say(what + " " + Quote.path(file.getFileName()) + ": " + percent + " %");
                }
            });
        }
    }

    @Override
    public boolean isCancelled() {
        return !model.fileWork().isWanted(file);
    }
}
