package lightning.editor.document;

import java.nio.file.Path;
import java.util.Set;
import lightning.base.file.FileState;
import lightning.base.file.SafeFile;

/** What an artist who was asked allows a save to do. */
public enum Consent {
    /** What another program wrote into the file meanwhile may be lost. */
    OVERWRITE_CHANGED,
    /** A read-only file may be replaced; it is read-only again then. */
    REPLACE_READ_ONLY;

    /** A file to write with what is allowed, where it was known to hold something. */
    static SafeFile to(Path file, FileState known, Set<Consent> allowed) {
        SafeFile safe = allowed.contains(REPLACE_READ_ONLY) ? SafeFile.at(file).evenReadOnly() : SafeFile.at(file);
        return allowed.contains(OVERWRITE_CHANGED) ? safe : safe.ifStill(known);
    }
}
