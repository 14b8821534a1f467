package lightning.base.file;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.GroupPrincipal;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.util.EnumSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Owner, group and mode of a file. Does nothing on systems without POSIX permissions.
 *
 * @param mode  the permissions
 * @param owner null for the user who creates the file
 * @param group null for the default group
 */
record FilePermissions(Set<PosixFilePermission> mode, @Nullable UserPrincipal owner, @Nullable GroupPrincipal group) {
    static final FilePermissions OWNER_ONLY = new FilePermissions(PosixFilePermissions.fromString("rw-------"), null, null);
    static final FilePermissions OWNER_ONLY_FOLDER = new FilePermissions(PosixFilePermissions.fromString("rwx------"), null, null);

    private static final Set<PosixFilePermission> GROUP_PERMISSIONS = Set.of(PosixFilePermission.GROUP_READ,
            PosixFilePermission.GROUP_WRITE, PosixFilePermission.GROUP_EXECUTE);

    /** Returns those of an existing file, or the defaults for a new one. */
    static FilePermissions forTarget(Path file) throws IOException {
        return Files.exists(file) ? of(file) : defaultsIn(requireNonNull(file.getParent()));
    }

    private static FilePermissions of(Path file) throws IOException {
        PosixFileAttributeView view = view(file);
        if (view == null) {
            return OWNER_ONLY;
        }
        PosixFileAttributes attributes = view.readAttributes();
        return new FilePermissions(attributes.permissions(), attributes.owner(), attributes.group());
    }

    /** Finds the system's defaults for new files in a folder by creating an empty one. */
    private static FilePermissions defaultsIn(Path folder) throws IOException {
        Path probe = Files.createFile(TemporaryFile.newPath(folder));
        try {
            return of(probe);
        } finally {
            Files.deleteIfExists(probe);
        }
    }

    /** Creates an empty file that never has wider permissions than these. */
    void create(Path file) throws IOException {
        Files.createFile(file, attributes(file));
    }

    /** Like {@link Files#createDirectories}; existing folders stay unchanged. */
    void createDirectories(Path folder) throws IOException {
        Files.createDirectories(folder, attributes(folder));
    }

    private FileAttribute<?>[] attributes(Path file) {
        return view(file) == null ? new FileAttribute<?>[0]
                : new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(mode)};
    }

    /** Applies them to an existing file or folder. If the group cannot be set, the group loses its permissions. */
    void applyTo(Path file) throws IOException {
        PosixFileAttributeView view = view(file);
        if (view == null) {
            return;
        }
        PosixFileAttributes current = view.readAttributes();
        Set<PosixFilePermission> applied = EnumSet.noneOf(PosixFilePermission.class);
        applied.addAll(mode);
        if (group != null && !group.equals(current.group()) && !tryRun(() -> view.setGroup(group))) {
            applied.removeAll(GROUP_PERMISSIONS);
        }
        if (!applied.equals(current.permissions())) {
            view.setPermissions(applied);
        }
        if (owner != null && !owner.equals(current.owner())) {
            tryRun(() -> view.setOwner(owner));
        }
    }

    private interface IoAction {
        void run() throws IOException;
    }

    /** Only some users may change a file's owner. */
    private static boolean tryRun(IoAction step) {
        try {
            step.run();
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private static @Nullable PosixFileAttributeView view(Path file) {
        return Files.getFileAttributeView(file, PosixFileAttributeView.class);
    }
}
