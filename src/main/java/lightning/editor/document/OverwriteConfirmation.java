package lightning.editor.document;

import java.nio.file.Path;
import java.util.Set;
import lightning.base.file.AtomicFile;
import lightning.base.file.FileState;

/** What an artist who was asked allows a save to do. */
public enum OverwriteConfirmation {
    /** What another program wrote into the file meanwhile may be lost. */
    OVERWRITE_CHANGED,
    /** A read-only file may be replaced; it is read-only again then. */
    REPLACE_READ_ONLY;

    /** A file to write with what is allowed, where it was known to hold something. */
    static AtomicFile safeFile(Path file, FileState knownState, Set<OverwriteConfirmation> allowed) {
        AtomicFile safe = allowed.contains(REPLACE_READ_ONLY) ? AtomicFile.of(file).allowReadOnly() : AtomicFile.of(file);
        return allowed.contains(OVERWRITE_CHANGED) ? safe : safe.ifUnchanged(knownState);
    }
}
