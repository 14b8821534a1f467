package lightning.base.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.time.Instant;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import lightning.base.text.Quote;

/**
 * Folder for temporary files of one process, readable by its owner only, never synced to disk and removed at the end. A killed process
 * leaves its folder; the next one created in the same place removes it. A lock, which the system releases with the process, marks a folder
 * as in use.
 */
public final class ScratchFolder implements AutoCloseable {
    private static final Pattern NAME_PATTERN = Pattern.compile("lightning-scratch-[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}");
    private static final String LOCK_FILE = "in-use";
    /** Start of the names of records of files outside. */
    private static final String OUTSIDE = "outside-";
    /** A folder without a lock is either being created or was left incomplete. */
    private static final Duration CREATION_GRACE = Duration.ofHours(1);

    /** Folders of this process: POSIX releases a lock when any stream to its file is closed, even one opened only to test it. */
    private static final Set<Path> OPEN_FOLDERS = ConcurrentHashMap.newKeySet();

    private final Path folder;
    private final FileChannel lock;

    private ScratchFolder(Path folder, FileChannel lock) {
        this.folder = folder;
        this.lock = lock;
    }

    /**
     * Creates a folder and removes folders left in the same place by ended processes.
     *
     * @throws IOException if it cannot be created; the message begins with {@code parent}
     */
    public static ScratchFolder createIn(Path parent) throws IOException {
        if (!Files.isDirectory(parent)) {
            throw new IOException(Quote.path(parent) + ": is not a folder");
        }
        removeStaleIn(parent);
        Path folder = parent.resolve("lightning-scratch-" + UUID.randomUUID());
        OPEN_FOLDERS.add(folder.getFileName());
        try {
            PrivateFolder.create(folder);
            Path lock = folder.resolve(LOCK_FILE + ".new");
            FilePermissions.OWNER_ONLY.create(lock);
            FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE);
            channel.lock();
            // A lock file with this name is always locked.
            Files.move(lock, folder.resolve(LOCK_FILE), StandardCopyOption.ATOMIC_MOVE);
            return new ScratchFolder(folder, channel);
        } catch (FileSystemException e) {
            remove(folder);
            OPEN_FOLDERS.remove(folder.getFileName());
            throw new IOException(Quote.path(parent) + ": cannot create a folder in it ("
                    + (e.getReason() == null ? e.getClass().getSimpleName() : e.getReason()) + ")", e);
        }
    }

    /** Returns the path of a file in the folder. */
    public Path file(String name) {
        return folder.resolve(name);
    }

    /**
     * Writes a new file.
     *
     * @throws IOException if it cannot be written, or {@code content} throws; the file then does not exist
     */
    public void write(Path file, AtomicFile.RandomAccessContent content) throws IOException {
        FilePermissions.OWNER_ONLY.create(file);
        boolean complete = false;
        try (var channel = new NamedChannel(FileChannel.open(file, StandardOpenOption.WRITE), file)) {
            content.writeTo(channel);
            complete = true;
        } finally {
            if (!complete) {
                Files.deleteIfExists(file);
            }
        }
    }

    /**
     * Records a file outside that belongs to the process: if it is killed, the file is removed with the folder, unless another file has
     * replaced it.
     */
    public void addOutside(Path file) throws IOException {
        Path record = folder.resolve(OUTSIDE + UUID.randomUUID());
        FilePermissions.OWNER_ONLY.create(record);
        Files.writeString(record, identity(file) + "\n" + file.toAbsolutePath());
    }

    /** Identifies a file whose content may change. */
    private static String identity(Path file) throws IOException {
        var attributes = Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        return attributes.fileKey() + " " + attributes.creationTime().toMillis() + " " + attributes.size();
    }

    private static void removeOutside(Path record) {
        try {
            String[] lines = Files.readString(record).split("\n", 2);
            Path file = Path.of(lines[1]);
            if (identity(file).equals(lines[0])) {
                Files.delete(file);
            }
        } catch (IOException | RuntimeException e) {
            // It is gone, or another file is there.
        }
    }

    /** Removes the folder with its content. */
    @Override
    public void close() {
        remove(folder);
        try {
            lock.close();
        } catch (IOException e) {
            // The system releases it with the process.
        }
        OPEN_FOLDERS.remove(folder.getFileName());
    }

    /** Removes folders that ended processes left. */
    public static void removeStaleIn(Path parent) {
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(parent, ScratchFolder::isScratchFolder)) {
            for (Path folder : folders) {
                if (isStale(folder)) {
                    removeFilesOutside(folder);
                    remove(folder);
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            // A folder that cannot be listed may still be writable.
        }
    }

    private static void removeFilesOutside(Path folder) throws IOException {
        try (DirectoryStream<Path> records = Files.newDirectoryStream(folder, OUTSIDE + "*")) {
            records.forEach(ScratchFolder::removeOutside);
        }
    }

    private static boolean isScratchFolder(Path folder) {
        return NAME_PATTERN.matcher(folder.getFileName().toString()).matches() && !OPEN_FOLDERS.contains(folder.getFileName())
                && Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS);
    }

    private static boolean isStale(Path folder) {
        Path lock = folder.resolve(LOCK_FILE);
        try {
            if (!Files.isRegularFile(lock, LinkOption.NOFOLLOW_LINKS)) {
                return Files.getLastModifiedTime(folder).toInstant().plus(CREATION_GRACE).isBefore(Instant.now());
            }
            try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
                    FileLock free = channel.tryLock()) {
                return free != null;
            }
        } catch (IOException e) {
            // Belongs to another user.
            return false;
        }
    }

    /** Removes a folder; never fails. The next process removes what is left. */
    private static void remove(Path folder) {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
            for (Path file : files) {
                if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
                    TemporaryFolder.delete(file);
                } else if (!file.getFileName().toString().equals(LOCK_FILE)) {
                    Files.deleteIfExists(file);
                }
            }
            Files.deleteIfExists(folder.resolve(LOCK_FILE));
            Files.deleteIfExists(folder);
        } catch (IOException | DirectoryIteratorException e) {
            // May belong to another user.
        }
    }
}
