package lightning.serve.resident;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import lightning.base.file.PrivateFolder;
import lightning.base.text.Quote;
import org.jspecify.annotations.Nullable;

/** Socket of the user's resident process. */
public final class ResidentPlace {
    private ResidentPlace() {}

    /**
     * Returns the socket's path in the user's folder for such files: in {@code XDG_RUNTIME_DIR}, else in the folder of temporary files. Creates
     * the folder of the socket.
     *
     * @throws IOException if the folder cannot be created, or if others can access it
     */
    public static Path socket() throws IOException {
        return in(System.getenv("XDG_RUNTIME_DIR"), Path.of(System.getProperty("java.io.tmpdir")), System.getProperty("user.name"));
    }

    static Path in(@Nullable String runtimeFolder, Path temporaryFolder, String user) throws IOException {
        Path folder = runtimeFolder != null && Path.of(runtimeFolder).isAbsolute() && Files.isDirectory(Path.of(runtimeFolder))
                ? Path.of(runtimeFolder, "lightning") : temporaryFolder.resolve("lightning-" + user);
        PrivateFolder.create(folder);
        requirePrivate(folder);
        return folder.resolve("resident");
    }

    /** Another user may have created the folder of temporary files, to read what a command sends. */
    private static void requirePrivate(Path folder) throws IOException {
        var view = Files.getFileAttributeView(folder, PosixFileAttributeView.class, LinkOption.NOFOLLOW_LINKS);
        if (view == null) {
            return;
        }
        var attributes = view.readAttributes();
        // The home folder is the user's, whatever name Java has for the user.
        boolean isOwn = attributes.owner().getName().equals(System.getProperty("user.name"))
                || attributes.owner().equals(Files.getOwner(Path.of(System.getProperty("user.home"))));
        if (!attributes.isDirectory() || !isOwn || !attributes.permissions().equals(PosixFilePermissions.fromString("rwx------"))) {
            throw new IOException(Quote.path(folder) + ": expected a folder that only you can access, found "
                    + PosixFilePermissions.toString(attributes.permissions()) + " of " + attributes.owner().getName());
        }
    }
}
