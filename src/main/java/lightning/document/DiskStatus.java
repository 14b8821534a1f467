package lightning.document;

import java.nio.file.Path;
import lightning.base.file.FileState;

/**
 * Observed state of an open scene's file on disk.
 *
 * @param file            scene file
 * @param known           content when this editor last read or wrote it
 * @param current         content now
 * @param isOpenElsewhere whether another editor has it open
 */
public record DiskStatus(Path file, FileState known, FileState current, boolean isOpenElsewhere) {

    /** Returns whether the file does not exist. */
    public boolean isMissing() {
        return current.equals(FileState.MISSING);
    }

    /** Returns whether the file existed and was deleted. */
    public boolean isDeleted() {
        return isMissing() && !known.equals(FileState.MISSING);
    }

    /** Returns whether another program changed the file. */
    public boolean isChanged() {
        return !isMissing() && !known.hasSameContent(current);
    }
}
