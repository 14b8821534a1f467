package lightning.editor.window.model;

import java.nio.file.Path;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.text.Messages;
import org.jspecify.annotations.Nullable;

/** File being read or written in the background, which the user can cancel. Files are compared by identity. */
public final class FileActivity {
    private final Runnable changeListener;
    private volatile @Nullable Path file;
    private final ReadOnlyStringWrapper title = new ReadOnlyStringWrapper("");

    FileActivity(Runnable changeListener) {
        this.changeListener = changeListener;
    }

    /** Starts reading a scene file. A previous activity is replaced. */
    public void beginReading(Path file) {
        begin(file, Messages.tr("Reading"));
    }

    /** Starts writing a file. A previous activity is replaced. */
    public void beginWriting(Path file) {
        begin(file, Messages.tr("Writing"));
    }

    private void begin(Path file, String title) {
        this.file = file;
        this.title.set(title);
        changeListener.run();
    }

    /** Ends the activity on a file, successful or not. Returns whether it was still active. */
    public boolean end(Path file) {
        boolean wasActive = isActive(file);
        if (wasActive) {
            this.file = null;
            changeListener.run();
        }
        return wasActive;
    }

    /** Returns true unless the activity on the file was canceled. Callable from any thread. */
    public boolean isActive(Path file) {
        return this.file == file;
    }

    /** Returns the active file, or null if there is none or it was canceled. */
    public @Nullable Path file() {
        return file;
    }

    /** Returns the activity's title, for example "Reading". Changes on the window's thread. */
    public ReadOnlyStringProperty titleProperty() {
        return title.getReadOnlyProperty();
    }

    /** Changes the title of the activity on a file to that of its next step, for example "Previewing". Ignored if it is not active. */
    public void setTitle(Path file, String title) {
        if (isActive(file)) {
            this.title.set(title);
        }
    }

    /** Cancels the activity. Returns whether there was one. */
    boolean cancel() {
        boolean wasActive = file != null;
        file = null;
        return wasActive;
    }
}
