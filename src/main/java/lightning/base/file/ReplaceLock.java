package lightning.base.file;

import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.WRITE;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * Lock of a folder while a file in it is compared and replaced, between all threads and processes that do the same. The system releases the
 * lock of a process that ends. The lock file exists meanwhile only; one that a killed process left is used again. On a network file system it
 * holds between machines if the mount shares locks; where files cannot be locked, threads of this process exclude each other only.
 */
record ReplaceLock(Path file, @Nullable FileChannel channel) implements AutoCloseable {
    private static final String FILE = ".lightning-replace.lock";
    /** Content of a removed lock file. */
    private static final byte[] REMOVED = {1};
    /** Each try but the last fails because another process finished in between. */
    private static final int MAX_TRIES = 10_000;
    private static final ReentrantLock THREADS = new ReentrantLock();

    /** Waits for the lock of a folder. */
    static ReplaceLock of(Path folder) {
        THREADS.lock();
        Path file = folder.resolve(FILE);
        FileChannel channel = null;
        try {
            for (int i = 0; i < MAX_TRIES && channel == null; i++) {
                channel = tryFile(file);
            }
        } catch (IOException e) {
            // Files cannot be locked here, or this file belongs to another user.
        }
        return new ReplaceLock(file, channel);
    }

    /** Returns the locked file; null if its last holder removed it meanwhile, so that others may lock a newer one. */
    private static @Nullable FileChannel tryFile(Path file) throws IOException {
        FileChannel channel = FileChannel.open(file, CREATE, WRITE, LinkOption.NOFOLLOW_LINKS);
        boolean isCurrent = false;
        try {
            channel.lock();
            // POSIX systems release the lock when any channel of the file closes, so the file is not opened again.
            isCurrent = channel.size() == 0 && Files.exists(file, LinkOption.NOFOLLOW_LINKS);
            return isCurrent ? channel : null;
        } finally {
            if (!isCurrent) {
                channel.close();
            }
        }
    }

    /** Removes the file, and marks it as removed for those who wait for its lock. */
    @Override
    public void close() {
        try (FileChannel held = channel) {
            if (held != null && Files.deleteIfExists(file)) {
                held.write(ByteBuffer.wrap(REMOVED));
            }
        } catch (IOException e) {
            // The next writer uses the file again, or removes it.
        } finally {
            THREADS.unlock();
        }
    }
}
