package lightning.editor.window.model;

import java.nio.file.Path;
import lightning.base.text.Messages;

/** The one file that is read or written beside the window's thread and may be given up. Files are told by identity. */
public final class FileActivity {
    private final Runnable changeListener;
    private volatile Path file;
    private boolean isWriting;

    FileActivity(Runnable changeListener) {
        this.changeListener = changeListener;
    }

    /** A scene file is being read, which may take its place here. */
    public void beginReading(Path file) {
        begin(file, false);
    }

    /** A file is being written that may be given up, as one that is read may. */
    public void beginWriting(Path file) {
        begin(file, true);
    }

    private void begin(Path file, boolean isWriting) {
        this.isWriting = isWriting;
        this.file = file;
        changeListener.run();
    }

    /** The work on a file is over, well or not; returns whether it was still wanted. */
    public boolean end(Path file) {
        boolean wasActive = isActive(file);
        if (wasActive) {
            this.file = null;
            changeListener.run();
        }
        return wasActive;
    }

    /** Whether nobody has given it up. Any thread may ask. */
    public boolean isActive(Path file) {
        return this.file == file;
    }

    /** What is read or written; null where nothing is, or it is not wanted any more. */
    public Path file() {
        return file;
    }

    /** What is done with {@link #file()}, as in "Reading". */
    public String title() {
        return isWriting ? Messages.tr("Writing") : Messages.tr("Reading");
    }

    /** Returns whether there was any. */
    boolean cancel() {
        boolean wasActive = file != null;
        file = null;
        return wasActive;
    }
}
