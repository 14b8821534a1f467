package lightning.document;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.UUID;
import lightning.base.file.PrivateFolder;
import org.jspecify.annotations.Nullable;

/**
 * Registry of the scenes open in all editors of one user. Each editor has a file in a common folder that names its scene, and holds a lock
 * on it. The system releases the lock when the process ends. Files without a lock are deleted. Not thread-safe.
 */
public final class OpenSceneRegistry implements AutoCloseable {
    private static final String EXTENSION = ".open";
    /** Lock position after any content: some systems do not allow reads of a locked range. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;
    /** Exceeds the time between creating and locking a file. */
    private static final Duration MIN_STALE_AGE = Duration.ofMinutes(1);
    /** Exceeds the length of any path. */
    private static final int MAX_BYTES = 1 << 16;

    private final Path folder;
    private final Path ownFile;
    private @Nullable FileChannel channel;

    /** @param folder dedicated folder, created when the first scene is opened */
    public OpenSceneRegistry(Path folder) {
        this.folder = folder;
        ownFile = folder.resolve(UUID.randomUUID() + EXTENSION);
    }

    /**
     * Registers an open scene in place of the previous one.
     *
     * @throws IOException if the registry cannot be written
     */
    public void register(Path scene) throws IOException {
        if (channel == null) {
            PrivateFolder.restrict(folder);
            channel = FileChannel.open(ownFile, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            lock(channel);
        }
        channel.truncate(0);
        channel.write(ByteBuffer.wrap(sceneId(scene).getBytes(StandardCharsets.UTF_8)), 0);
    }

    /** Locks the own file. Another editor that looks for open scenes may have its lock for a moment; in this process, Java does not wait for that. */
    private static void lock(FileChannel channel) throws IOException {
        while (true) {
            try {
                channel.lock(LOCKED_BYTE, 1, false);
                return;
            } catch (OverlappingFileLockException e) {
                Thread.onSpinWait();
            }
        }
    }

    /**
     * Returns whether another editor has a scene open, resolving links.
     *
     * @throws IOException if the folder cannot be read
     */
    public boolean isOpenElsewhere(Path scene) throws IOException {
        String name = sceneId(scene);
        boolean open = false;
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, "*" + EXTENSION)) {
            for (Path other : all) {
                open |= !other.equals(ownFile) && isLocked(other) && containsName(other, name);
            }
        } catch (DirectoryIteratorException e) {
            throw e.getCause();
        }
        return open;
    }

    private static boolean isLocked(Path other) {
        try (FileChannel file = FileChannel.open(other, StandardOpenOption.WRITE);
                FileLock lock = file.tryLock(LOCKED_BYTE, 1, false)) {
            if (lock == null) {
                return true;
            }
            if (Files.getLastModifiedTime(other).toInstant().isBefore(Instant.now().minus(MIN_STALE_AGE))) {
                Files.deleteIfExists(other);
            }
            return false;
        } catch (OverlappingFileLockException e) {
            // Another editor of the same process.
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private static boolean containsName(Path other, String name) {
        try (var in = Files.newInputStream(other)) {
            return new String(in.readNBytes(MAX_BYTES), StandardCharsets.UTF_8).equals(name);
        } catch (IOException e) {
            return false;
        }
    }

    /** Returns the canonical identity of a file, on one line. */
    private static String sceneId(Path scene) {
        Path absolute = scene.toAbsolutePath();
        URI name;
        try {
            name = absolute.toRealPath().toUri();
        } catch (IOException e) {
            name = absolute.normalize().toUri();
        }
        return name.toString();
    }

    /** Unregisters the open scene. */
    @Override
    public void close() {
        try (FileChannel openChannel = channel) {
            if (openChannel != null) {
                Files.deleteIfExists(ownFile);
            }
        } catch (IOException e) {
            // The next editor deletes it.
        }
        channel = null;
    }
}
