package lightning.base.file;

import java.nio.file.Path;

/** Folder that contains a file. */
public final class ParentFolder {
    private ParentFolder() {}

    /** Returns the absolute path of the folder that contains a file; that of a root is the root. */
    public static Path of(Path file) {
        Path absolute = file.toAbsolutePath();
        Path parent = absolute.getParent();
        return parent == null ? absolute : parent;
    }
}
