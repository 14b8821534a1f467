package lightning.base.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import lightning.base.text.Quote;

/**
 * File that other processes map into their memory. Only its owner can access it. Unlike {@link AtomicFile} it is overwritten in place, so
 * that mappings show the new content. All its bytes are allocated when it is created: a full memory is then an error, and not a crash of
 * a process that maps it. Threads may write different parts at the same time.
 */
public record SharedMemoryFile(Path path, long bytes) implements AutoCloseable {
    /** Folder of memory that processes share, on Linux. */
    private static final Path SHARED_MEMORY = Path.of("/dev/shm");
    private static final int CHUNK = 1 << 20;

    /** Returns the folder for such files: shared memory if the system has it, else the folder for temporary files. */
    public static Path folder() {
        return Files.isDirectory(SHARED_MEMORY) && Files.isWritable(SHARED_MEMORY) ? SHARED_MEMORY
                : Path.of(System.getProperty("java.io.tmpdir"));
    }

    /**
     * Creates a file of zeros.
     *
     * @throws IOException if it exists, or there is no space for it; the message is a sentence for the user
     */
    public static SharedMemoryFile create(Path path, long bytes) throws IOException {
        try {
            FilePermissions.OWNER_ONLY.create(path);
        } catch (FileAlreadyExistsException e) {
            throw new IOException(Quote.path(path) + ": exists already; only files that the server made are overwritten", e);
        }
        boolean complete = false;
        try (FileChannel channel = open(path)) {
            ByteBuffer zeros = ByteBuffer.allocateDirect((int) Math.min(CHUNK, bytes));
            for (long at = 0; at < bytes; at += CHUNK) {
                zeros.clear().limit((int) Math.min(CHUNK, bytes - at));
                writeFully(channel, zeros, at);
            }
            complete = true;
            return new SharedMemoryFile(path, bytes);
        } finally {
            if (!complete) {
                Files.deleteIfExists(path);
            }
        }
    }

    private static void writeFully(FileChannel channel, ByteBuffer from, long position) throws IOException {
        for (long at = position; from.hasRemaining();) {
            at += channel.write(from, at);
        }
    }

    private static FileChannel open(Path path) throws IOException {
        return FileChannel.open(path, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
    }

    /** Opens the file to overwrite it. Between pictures it is closed, because a client may name many files. */
    public Writer openWriter() throws IOException {
        return new Writer(open(path));
    }

    /** Overwrites parts of the file. */
    public record Writer(FileChannel channel) implements AutoCloseable {
        /**
         * Overwrites a part.
         *
         * @param position first byte of the part, which must be inside the file
         */
        public void write(ByteBuffer content, long position) throws IOException {
            writeFully(channel, content, position);
        }

        @Override
        public void close() throws IOException {
            channel.close();
        }
    }

    /** Removes the file. Mappings of other processes stay valid. */
    @Override
    public void close() throws IOException {
        Files.deleteIfExists(path);
    }
}
