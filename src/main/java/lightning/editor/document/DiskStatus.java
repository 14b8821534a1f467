package lightning.editor.document;

import java.nio.file.Path;
import lightning.base.file.FileState;

/**
 * What was seen of an open scene's file on disk.
 *
 * @param file      the scene's file
 * @param known     what it held when it was read or written here
 * @param current      what it holds now
 * @param isOpenElsewhere whether another editor has it open
 */
public record DiskStatus(Path file, FileState known, FileState current, boolean isOpenElsewhere) {

    /** Whether the file was there and is not any more. */
    public boolean isDeleted() {
        return current.equals(FileState.MISSING) && !known.equals(FileState.MISSING);
    }

    /** Whether somebody else wrote the file. */
    public boolean isChanged() {
        return !current.equals(FileState.MISSING) && !known.hasSameContent(current);
    }
}
