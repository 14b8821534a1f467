package lightning.editor.window.timeline;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import javafx.concurrent.Task;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;

/** Exports a shot on a separate thread. Its value is the number of frames written. */
final class ShotExportTask extends Task<Integer> {
    private final ShotExport export;
    private int written;

    ShotExportTask(ShotExport export) {
        this.export = export;
        updateValue(0);
        updateProgress(0, 1);
    }

    @Override
    protected Integer call() throws IOException {
        try {
            export.write(new Progress() {
                @Override
                public void report(int done, int total) {
                    updateProgress(written + (double) done / Math.max(1, total), export.frames());
                }

                @Override
                public boolean isCanceled() {
                    return ShotExportTask.this.isCancelled();
                }
            }, frames -> {
                written = frames;
                updateValue(frames);
                updateProgress(frames, export.frames());
            });
        } catch (CancellationException e) {
            // The task's state is already canceled.
            return written;
        }
        return export.frames();
    }

    ShotExport export() {
        return export;
    }

    /** Starts the thread. Never interrupt it: that would corrupt a file that is being written. */
    void start() {
        DedicatedThread.create("lightning-shot-export", this).start();
    }
}
