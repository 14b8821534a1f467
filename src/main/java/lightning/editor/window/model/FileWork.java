package lightning.editor.window.model;

import java.nio.file.Path;
import lightning.base.text.Texts;

/** The one file that is read or written beside the window's thread and may be given up. Files are told by identity. */
public final class FileWork {
    private final Runnable changed;
    private volatile Path file;
    private boolean writing;

    FileWork(Runnable changed) {
        this.changed = changed;
    }

    /** A scene file is being read, which may take its place here. */
    public void read(Path file) {
        begin(file, false);
    }

    /** A file is being written that may be given up, as one that is read may. */
    public void write(Path file) {
        begin(file, true);
    }

    private void begin(Path file, boolean writing) {
        this.writing = writing;
        this.file = file;
        changed.run();
    }

    /** The work on a file is over, well or not; returns whether it was still wanted. */
    public boolean end(Path file) {
        boolean wanted = isWanted(file);
        if (wanted) {
            this.file = null;
            changed.run();
        }
        return wanted;
    }

    /** Whether nobody has given it up. Any thread may ask. */
    public boolean isWanted(Path file) {
        return this.file == file;
    }

    /** What is read or written; null where nothing is, or it is not wanted any more. */
    public Path file() {
        return file;
    }

    /** What is done with {@link #file()}, as in "Reading". */
    public String title() {
        return writing ? Texts.of("Writing") : Texts.of("Reading");
    }

    /** Returns whether there was any. */
    boolean giveUp() {
        boolean any = file != null;
        file = null;
        return any;
    }
}
