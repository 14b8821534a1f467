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
    public static void create(Path folder) throws IOException {
        FilePermissions.OWNER_ONLY_FOLDER.createDirectories(folder);
    }

    /** The same, and one that was open to others is closed to them: for folders that hold nothing but the program's own. */
    public static void restrict(Path folder) throws IOException {
        create(folder);
        FilePermissions.OWNER_ONLY_FOLDER.applyTo(folder);
    }
}
