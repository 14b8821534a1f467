package lightning.document;

import java.nio.file.Path;
import java.util.Set;
import lightning.base.file.AtomicFile;
import lightning.base.file.FileState;

/** Confirmed overwrites of a save. */
public enum OverwriteConfirmation {
    /** Overwrites changes by another program. */
    OVERWRITE_CHANGED,
    /** Replaces a read-only file, which is read-only again afterwards. */
    REPLACE_READ_ONLY;

    /** Returns a writer for a file with these confirmations and its last known state. */
    static AtomicFile safeFile(Path file, FileState knownState, Set<OverwriteConfirmation> allowed) {
        AtomicFile safe = allowed.contains(REPLACE_READ_ONLY) ? AtomicFile.of(file).allowReadOnly() : AtomicFile.of(file);
        return allowed.contains(OVERWRITE_CHANGED) ? safe : safe.ifUnchanged(knownState);
    }
}
