package lightning.base.file;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Set;
import lightning.base.text.Quote;

/** Resolution of the file that a path leads to. */
final class WriteTarget {
    /** Maximum chain of links, as in Linux. */
    private static final int MAX_LINKS = 40;
    private static final Set<PosixFilePermission> WRITE_PERMISSIONS = Set.of(PosixFilePermission.OWNER_WRITE,
            PosixFilePermission.GROUP_WRITE, PosixFilePermission.OTHERS_WRITE);

    private WriteTarget() {}

    /**
     * Follows symbolic links, the last of which may point to a missing file.
     *
     * @return an absolute path that is no link, in an existing folder; a regular file or missing
     * @throws IOException if that is impossible, or the folder is not writable; the message begins with {@code path}
     */
    static Path resolve(Path path) throws IOException {
        Path file = resolveLinks(path);
        if (Files.isDirectory(file)) {
            throw new IOException(Quote.path(path) + ": expected a file, found a folder");
        }
        // Only a root folder has no parent.
        Path folder = requireNonNull(file.getParent());
        if (!Files.isDirectory(folder)) {
            throw new IOException(Quote.path(path) + ": folder not found: " + Quote.path(folder));
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IOException(Quote.path(path) + ": expected a file, found a device, a pipe or a socket");
        }
        if (!Files.isWritable(folder)) {
            throw new IOException(Quote.path(path) + ": no permission to write to " + Quote.path(folder));
        }
        return file;
    }

    private static Path resolveLinks(Path path) throws IOException {
        Path file = path.toAbsolutePath();
        if (Files.exists(file)) {
            return file.toRealPath();
        }
        for (int links = 0; Files.isSymbolicLink(file); links++) {
            if (links == MAX_LINKS) {
                throw new IOException(Quote.path(path) + ": circular symbolic link");
            }
            file = file.resolveSibling(Files.readSymbolicLink(file));
        }
        return file;
    }

    /**
     * Returns whether the file exists and is read-only for this user or for all. An administrator may write files that are read-only for
     * all.
     */
    static boolean isReadOnly(Path file) throws IOException {
        if (!Files.exists(file)) {
            return false;
        }
        var view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        boolean lacksWriteMode = view != null && view.readAttributes().permissions().stream().noneMatch(WRITE_PERMISSIONS::contains);
        return lacksWriteMode || !Files.isWritable(file);
    }
}
