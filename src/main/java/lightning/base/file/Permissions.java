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
record Permissions(Set<PosixFilePermission> mode, UserPrincipal owner, GroupPrincipal group) {
    static final Permissions OWNER_ONLY = new Permissions(PosixFilePermissions.fromString("rw-------"), null, null);
    static final Permissions OWNERS_FOLDER = new Permissions(PosixFilePermissions.fromString("rwx------"), null, null);

    private static final Set<PosixFilePermission> OF_GROUP = Set.of(PosixFilePermission.GROUP_READ,
            PosixFilePermission.GROUP_WRITE, PosixFilePermission.GROUP_EXECUTE);

    /** Those of a file, or of a new one where there is none. */
    static Permissions replacing(Path file) throws IOException {
        return Files.exists(file) ? of(file) : ofNew(file.getParent());
    }

    private static Permissions of(Path file) throws IOException {
        PosixFileAttributeView view = view(file);
        if (view == null) {
            return OWNER_ONLY;
        }
        PosixFileAttributes all = view.readAttributes();
        return new Permissions(all.permissions(), all.owner(), all.group());
    }

    /** Only the system knows what it gives to new files in a folder: an empty one shows it. */
    private static Permissions ofNew(Path folder) throws IOException {
        Path example = Files.createFile(TemporaryFile.in(folder));
        try {
            return of(example);
        } finally {
            Files.deleteIfExists(example);
        }
    }

    /** Makes an empty file; at no moment may anybody else open it. */
    void create(Path file) throws IOException {
        Files.createFile(file, attributes(file));
    }

    /** As {@link Files#createDirectories}; folders that are there stay as they are. */
    void createFolders(Path folder) throws IOException {
        Files.createDirectories(folder, attributes(folder));
    }

    private FileAttribute<?>[] attributes(Path file) {
        return view(file) == null ? new FileAttribute<?>[0]
                : new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(mode)};
    }

    /** Gives them to a file or folder that is there. What belongs to another group than wanted is closed to that group. */
    void giveTo(Path file) throws IOException {
        PosixFileAttributeView view = view(file);
        if (view == null) {
            return;
        }
        PosixFileAttributes now = view.readAttributes();
        Set<PosixFilePermission> given = EnumSet.noneOf(PosixFilePermission.class);
        given.addAll(mode);
        if (group != null && !group.equals(now.group()) && !succeeds(() -> view.setGroup(group))) {
            given.removeAll(OF_GROUP);
        }
        if (!given.equals(now.permissions())) {
            view.setPermissions(given);
        }
        if (owner != null && !owner.equals(now.owner())) {
            succeeds(() -> view.setOwner(owner));
        }
    }

    private interface Step {
        void run() throws IOException;
    }

    /** Only some users may give a file away. */
    private static boolean succeeds(Step step) {
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
