package lightning.base.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Set;
import lightning.base.text.Quote;

/** The file that a name leads to. */
final class WriteTarget {
    /** As many links in a row as Linux follows. */
    private static final int MAX_LINKS = 40;
    private static final Set<PosixFilePermission> WRITE_PERMISSIONS = Set.of(PosixFilePermission.OWNER_WRITE,
            PosixFilePermission.GROUP_WRITE, PosixFilePermission.OTHERS_WRITE);

    private WriteTarget() {}

    /**
     * Follows links, the last of which may lead to a file that is not there yet.
     *
     * @return an absolute name that is no link, in a folder that is there; what it names is a regular file or nothing
     * @throws IOException if that cannot be, or the folder cannot be written; a sentence that begins with {@code path}
     */
    static Path resolve(Path path) throws IOException {
        Path file = resolveLinks(path);
        if (Files.isDirectory(file)) {
            throw new IOException(Quote.path(path) + ": expected a file, found a folder");
        }
        Path folder = file.getParent();
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

    /** Whether it is there, and this user may not write it or nobody may. An administrator may write what nobody may. */
    static boolean isReadOnly(Path file) throws IOException {
        if (!Files.exists(file)) {
            return false;
        }
        var view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        boolean lacksWriteMode = view != null && view.readAttributes().permissions().stream().noneMatch(WRITE_PERMISSIONS::contains);
        return lacksWriteMode || !Files.isWritable(file);
    }
}
