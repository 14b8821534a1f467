package lightning.base.file;

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

/**
 * Who may read and write a file. On a system that knows no such modes everything here does nothing.
 *
 * @param mode  who may do what
 * @param owner null for whoever creates the file; likewise {@code group}
 */
record FilePermissions(Set<PosixFilePermission> mode, UserPrincipal owner, GroupPrincipal group) {
    static final FilePermissions OWNER_ONLY = new FilePermissions(PosixFilePermissions.fromString("rw-------"), null, null);
    static final FilePermissions OWNER_ONLY_FOLDER = new FilePermissions(PosixFilePermissions.fromString("rwx------"), null, null);

    private static final Set<PosixFilePermission> GROUP_PERMISSIONS = Set.of(PosixFilePermission.GROUP_READ,
            PosixFilePermission.GROUP_WRITE, PosixFilePermission.GROUP_EXECUTE);

    /** Those of a file, or of a new one where there is none. */
    static FilePermissions forTarget(Path file) throws IOException {
        return Files.exists(file) ? of(file) : defaultsIn(file.getParent());
    }

    private static FilePermissions of(Path file) throws IOException {
        PosixFileAttributeView view = view(file);
        if (view == null) {
            return OWNER_ONLY;
        }
        PosixFileAttributes attributes = view.readAttributes();
        return new FilePermissions(attributes.permissions(), attributes.owner(), attributes.group());
    }

    /** Only the system knows what it gives to new files in a folder: an empty one shows it. */
    private static FilePermissions defaultsIn(Path folder) throws IOException {
        Path probe = Files.createFile(TemporaryFile.newPath(folder));
        try {
            return of(probe);
        } finally {
            Files.deleteIfExists(probe);
        }
    }

    /** Makes an empty file; at no moment may anybody else open it. */
    void create(Path file) throws IOException {
        Files.createFile(file, attributes(file));
    }

    /** As {@link Files#createDirectories}; folders that are there stay as they are. */
    void createDirectories(Path folder) throws IOException {
        Files.createDirectories(folder, attributes(folder));
    }

    private FileAttribute<?>[] attributes(Path file) {
        return view(file) == null ? new FileAttribute<?>[0]
                : new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(mode)};
    }

    /** Gives them to a file or folder that is there. What belongs to another group than wanted is closed to that group. */
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

    /** Only some users may give a file away. */
    private static boolean tryRun(IoAction step) {
        try {
            step.run();
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private static PosixFileAttributeView view(Path file) {
        return Files.getFileAttributeView(file, PosixFileAttributeView.class);
    }
}
