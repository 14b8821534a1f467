package lightning.editor.document;

import java.nio.file.Path;
import lightning.base.file.FileState;

/**
 * What was seen of an open scene's file on disk.
 *
 * @param file      the scene's file
 * @param known     what it held when it was read or written here
 * @param seen      what it holds now
 * @param elsewhere whether another editor has it open
 */
public record DiskNews(Path file, FileState known, FileState seen, boolean elsewhere) {

    /** Whether the file was there and is not any more. */
    public boolean isGone() {
        return seen.equals(FileState.NONE) && !known.equals(FileState.NONE);
    }

    /** Whether somebody else wrote the file. */
    public boolean isChanged() {
        return !seen.equals(FileState.NONE) && !known.holdsTheSameAs(seen);
    }
}
