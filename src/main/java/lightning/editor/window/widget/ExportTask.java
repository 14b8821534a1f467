package lightning.editor.window.widget;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import javafx.concurrent.Task;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;

/** Writes frames to files on a separate thread. Its value is the number of frames written. */
public final class ExportTask extends Task<Integer> {
    private final int frames;
    private final Writer writer;
    private int written;

    /** Writes all frames and blocks until done. */
    public interface Writer {
        /**
         * @param progress receives the tiles of each frame, and can cancel
         * @param listener receives the number of frames written
         * @throws CancellationException if canceled; finished files are kept
         */
        void write(Progress progress, IntConsumer listener) throws IOException;
    }

    public ExportTask(int frames, Writer writer) {
        this.frames = frames;
        this.writer = writer;
        updateValue(0);
        updateProgress(0, 1);
    }

    @Override
    protected Integer call() throws IOException {
        try {
            writer.write(new Progress() {
                @Override
                public void report(int done, int total) {
                    updateProgress(written + (double) done / Math.max(1, total), frames);
                }

                @Override
                public boolean isCanceled() {
                    return ExportTask.this.isCancelled();
                }
            }, count -> {
                written = count;
                updateValue(count);
                updateProgress(count, frames);
            });
        } catch (CancellationException e) {
            // The task's state is already canceled.
            return written;
        }
        return frames;
    }

    public int frames() {
        return frames;
    }

    /** Starts the thread. Never interrupt it: that would corrupt a file that is being written. */
    public void start() {
        DedicatedThread.create("lightning-export", this).start();
    }
}
