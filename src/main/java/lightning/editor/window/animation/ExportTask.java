package lightning.editor.window.animation;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import javafx.concurrent.Task;
import lightning.base.work.DedicatedThread;
import lightning.editor.document.motion.MotionExport;

/** Exports a motion path as numbered images on a separate thread. Its value is the number of images written. */
final class ExportTask extends Task<Integer> {
    private final MotionExport export;
    private final Path folder;
    private final String name;

    ExportTask(MotionExport export, Path folder, String name) {
        this.export = export;
        this.folder = folder;
        this.name = name;
        updateValue(0);
    }

    @Override
    protected Integer call() throws IOException {
        try {
            export.write(folder, name, new MotionExport.Listener() {
                @Override
                public void pictureWritten(int pictures) {
                    updateValue(pictures);
                    updateProgress(pictures, export.pictureCount());
                }

                @Override
                public boolean isCanceled() {
                    return ExportTask.this.isCancelled();
                }
            });
        } catch (CancellationException e) {
            // The task's state is already canceled.
            return export.pictureCount();
        }
        return export.pictureCount();
    }

    Path folder() {
        return folder;
    }

    int pictures() {
        return export.pictureCount();
    }

    /** Starts the thread. Never interrupt it: that would corrupt a file that is being written. */
    void start() {
        Thread thread = DedicatedThread.create("lightning-export", this);
        thread.start();
    }
}
