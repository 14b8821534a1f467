package lightning.base.file;

import java.io.IOException;
import java.nio.file.Path;

/** Folders that nobody but their owner may look into. */
public final class PrivateFolder {
    private PrivateFolder() {}

    /**
     * Makes a folder, and those above it that are missing. A folder that is there stays as it is.
     *
     * @throws IOException if it cannot be made, or is there and is no folder
     */
    public static void make(Path folder) throws IOException {
        Permissions.OWNERS_FOLDER.createFolders(folder);
    }

    /** The same, and one that was open to others is closed to them: for folders that hold nothing but the program's own. */
    public static void close(Path folder) throws IOException {
        make(folder);
        Permissions.OWNERS_FOLDER.giveTo(folder);
    }
}
