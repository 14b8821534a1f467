package lightning.base.file;

import java.io.IOException;
import java.nio.file.Path;

/** Folders that only their owner can access. */
public final class PrivateFolder {
    private PrivateFolder() {}

    /**
     * Creates a folder and its missing parents. An existing folder stays unchanged.
     *
     * @throws IOException if it cannot be created, or is not a folder
     */
    public static void create(Path folder) throws IOException {
        FilePermissions.OWNER_ONLY_FOLDER.createDirectories(folder);
    }

    /** Creates a folder, or restricts an existing one to its owner: for folders that hold only the program's own files. */
    public static void restrict(Path folder) throws IOException {
        create(folder);
        FilePermissions.OWNER_ONLY_FOLDER.applyTo(folder);
    }
}
